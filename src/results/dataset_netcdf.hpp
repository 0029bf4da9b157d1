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

  /// Adds missing attributes, dimensions and variables of a dataset, with the values of all that do not grow. A
  /// dimension of unknown final size is added with its first entries.
  void add(const Dataset& dataset);

  /// Appends the entries in memory of all growing variables.
  void append(const Dataset& dataset);

 private:
  void add(const Dataset& dataset, const Variable& variable);

  NewNetcdf& file_;
  std::map<std::string, netCDF::NcDim> dims_;
  std::map<std::string, netCDF::NcVar> variables_;
  std::map<std::string, std::size_t> written_;  ///< entries of growing dimensions
};

}  // namespace bumpfoil
