#pragma once

#include <string>

#include "bumpfoil/experiments/vibration/vibration.hpp"

namespace bumpfoil {

/// Contents of vibration.csv: one line per vibration. Like all tables: a header with units in its names, numbers with
/// 17 significant digits, and an empty cell for an unknown number.
std::string vibration_csv(const VibrationSettings& settings, const VibrationResult& result);

/// Contents of coefficients.csv: one line per load, amplitude and frequency.
std::string coefficients_csv(const VibrationSettings& settings, const std::vector<LinearFoils>& all);

}  // namespace bumpfoil
