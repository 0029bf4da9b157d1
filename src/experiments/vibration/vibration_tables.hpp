#pragma once

#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/results/table.hpp"

/// Tables of vibration_dataset().
namespace bumpfoil {

/// Rows of vibration.csv: one for each vibration.
Table loop_table(const Dataset& data, const VibrationSettings& settings);

/// Rows of coefficients.csv: stiffness and damping about each load, with each amplitude, at each frequency.
Table coefficient_table(const Dataset& data);

}  // namespace bumpfoil
