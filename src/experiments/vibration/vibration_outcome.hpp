#pragma once

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"

namespace bumpfoil {

/// What a run of vibrations has to show.
Outcome vibration_outcome(const Case& input, VibrationResult result);

}  // namespace bumpfoil
