#pragma once

#include <string>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle_files.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// How a run ended.
RunStatus status_of(const VibrationResult& result);

/// Names of the files that the command writes.
std::vector<std::string> vibration_file_names();

/// The files of a run, as docs/results.md describes them: vibration.csv, coefficients.csv, coefficients.toml, result.nc
/// and summary.json, with one new run id.
///
/// netCDF is not thread-safe: to be called by one thread at a time.
/// @throws Error (file) if the memory does not suffice
std::vector<ResultFile> vibration_files(const Case& input, const VibrationResult& result, RunStatus status,
                                        const Provenance& provenance);

/// The coefficients as a text table: about each load with each amplitude a line.
std::string vibration_table(const Case& input, const VibrationResult& result);

/// A line for each load that was not reached, and for each vibration that failed about one that was: place and reason.
std::vector<std::string> failure_lines(const Case& input, const VibrationResult& result);

/// A line for each vibration that has not settled.
std::vector<std::string> warning_lines(const Case& input, const VibrationResult& result);

}  // namespace bumpfoil
