#pragma once

#include <netcdf>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "results/netcdf_writer.hpp"

namespace bumpfoil {

/// What the attributes of a file tell of the run that it comes from.
struct RunOrigin {
  const Case& input;
  std::string_view command;
  RunStatus status;
  std::string message;  ///< what keeps the results from being complete
  std::vector<std::string> warnings;
  const Provenance& provenance;
  std::string_view run_id;
};

/// Adds the attributes that all files of results have.
void add_provenance(NewNetcdf& file, const RunOrigin& origin);

/// The Error of a file that netCDF could not build, which is for want of memory. @param advice  what takes less
Error unbuilt(std::string_view name, const netCDF::exceptions::NcException& error, std::string_view advice);

}  // namespace bumpfoil
