#pragma once

#include <vector>

#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// Loads, vibrations and coefficients over the dimensions load, direction or sense, amplitude, frequency, point for
/// loops, and pad if there are several. @param all  linear_foils() of the result
Dataset vibration_dataset(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all,
                          bool with_loops = true);

}  // namespace bumpfoil
