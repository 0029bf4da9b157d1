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

/// The files of a run, as docs/results.md describes them: cycle.csv or strip.csv, result.nc and summary.json. They
/// carry the same new run id, and summary.json the checksums of the others, so that readers can tell a whole set from a
/// damaged or mixed one.
///
/// netCDF is not thread-safe: to be called by one thread at a time.
/// @throws Error (file) if the memory does not suffice
std::vector<ResultFile> cycle_files(const Case& input, const CycleResult& result, RunStatus status,
                                    const Provenance& provenance);

}  // namespace bumpfoil
