#pragma once

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"

namespace bumpfoil {

/// Outcome of a run of vibrations.
Outcome vibration_outcome(const Case& input, VibrationResult result);

}  // namespace bumpfoil
