#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "bumpfoil/results/dataset.hpp"
#include "results/netcdf_writer.hpp"

namespace bumpfoil {

/// Datasets as variables of a netCDF file.
class DatasetNetcdf {
 public:
  /// @param file  outlives this
  explicit DatasetNetcdf(NewNetcdf& file) : file_(file) {}

  /// Adds the attributes, dimensions and variables of a dataset that are not there, with the values of all that do not
  /// grow. A dimension of which it is not known how far it will grow comes with its first entries.
  void add(const Dataset& dataset);

  /// Appends the entries in memory of all variables that grow.
  void append(const Dataset& dataset);

 private:
  void add(const Dataset& dataset, const Variable& variable);

  NewNetcdf& file_;
  std::map<std::string, netCDF::NcDim> dims_;
  std::map<std::string, netCDF::NcVar> variables_;
  std::map<std::string, std::size_t> written_;  ///< entries of dimensions that grow
};

}  // namespace bumpfoil
