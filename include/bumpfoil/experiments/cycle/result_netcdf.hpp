#pragma once

#include <string>
#include <string_view>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Contents of result.nc: netCDF-4 after the CF conventions, with everything that is known of every increment, bump and
/// foot, the geometry that it takes to draw it, and the provenance; docs/results.md lists all of it. Increments that a
/// failed or interrupted run did not reach, and quantities that are not known, are the fill value of their variable;
/// numbers that are not finite, too. The attribute `status` says "complete" or "partial".
///
/// The file is built in memory: netCDF reads paths its own way (URLs, backslashes, leading blanks), and a disk that
/// fills up beneath it ends in a crash. It is not thread-safe: to be called by one thread at a time.
///
/// @param run_id  the same in all files of a run
/// @throws Error (file) if netCDF cannot build it, which is for want of memory
std::string result_netcdf(const Case& input, const CycleResult& result, RunStatus status, const Provenance& provenance,
                          std::string_view run_id);

}  // namespace bumpfoil
