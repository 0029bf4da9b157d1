#pragma once

#include <filesystem>
#include <string>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/io/summary.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Where a result comes from, for those who open it years later. What is empty is left out.
struct Provenance {
  std::string command_line;
  std::string case_text;  ///< of the case file, as its author wrote it
};

/// Writes result.nc: netCDF-4 after the CF conventions, with everything that is known of every increment, bump and
/// foot, the geometry that it takes to draw it, and the provenance; docs/results.md lists all of it. Increments that a
/// failed or interrupted run did not reach, and quantities that are not known, are the fill value of their variable;
/// numbers that are not finite, too. The attribute `status` says "complete" or "partial".
///
/// netCDF is not thread-safe: to be called by one thread at a time.
///
/// @param path  written in place: to be a temporary name, see ResultFolder::stage
/// @throws Error (file) if it cannot be written
void write_result_netcdf(const std::filesystem::path& path, const Case& input, const CycleResult& result,
                         RunStatus status, const Provenance& provenance);

}  // namespace bumpfoil
