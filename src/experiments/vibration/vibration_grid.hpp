#pragma once

#include <vector>

#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "results/result_grid.hpp"

namespace bumpfoil {

/// Loads, vibrations and coefficients over the dimensions load, direction or sense, amplitude, frequency and, of the
/// loops, point; of several pads pad, too. @param all  linear_foils() of the result
ResultGrid vibration_grid(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all,
                          bool with_loops = true);

/// A result of which nothing was begun.
VibrationResult vibrations_not_begun(const VibrationSettings& settings);

}  // namespace bumpfoil
