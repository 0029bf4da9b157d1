#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Names of the files that the command of this name writes.
std::vector<std::string> cycle_file_names(std::string_view command);

/// The files of a run, as docs/results.md describes them: cycle.csv, strip.csv or path.csv; result.nc with everything
/// that is known of every increment, bump and foot and the geometry that it takes to draw it; summary.json with the
/// quantities of every cycle. They carry the same new run id, and summary.json the checksums of the others, so that
/// readers can tell a whole set from a damaged or mixed one. What was not reached, or is not known, is the fill value
/// of its variable, and null in summary.json.
///
/// netCDF is not thread-safe: to be called by one thread at a time.
/// @throws Error (file) if the memory does not suffice
std::vector<ResultFile> cycle_files(const Case& input, const CycleResult& result, RunStatus status,
                                    const Provenance& provenance);

}  // namespace bumpfoil
