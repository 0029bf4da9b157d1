#pragma once

#include <string>
#include <vector>

#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// How a run ended.
RunStatus status_of(const VibrationResult& result);

/// The coefficients as a text table: about each load with each amplitude a line.
std::string vibration_table(const Case& input, const VibrationResult& result);

/// A line for each load that was not reached, and for each vibration that failed about one that was: place and reason.
std::vector<std::string> failure_lines(const Case& input, const VibrationResult& result);

/// A line for each vibration that has not settled.
std::vector<std::string> warning_lines(const Case& input, const VibrationResult& result);

}  // namespace bumpfoil
