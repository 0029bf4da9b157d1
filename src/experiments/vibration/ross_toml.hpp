#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/vibration/vibration.hpp"

namespace bumpfoil {

/// Frequencies (rad/s, rising) that coefficients are given at to rotor dynamics, which interpolates between them: those
/// of the case if they are five or more; if fewer, these and nine at equal ratios from half of the lowest to twice the
/// highest. Damping falls as 1/omega, and a curve through fewer points would miss it.
std::vector<double> exported_frequencies(std::vector<double> frequencies);

/// Contents of coefficients.toml: of each load and amplitude with all coefficients known the arguments of the
/// constructor of ROSS's BearingElement, with comments that say what they are and are not. docs/rotor_dynamics.md
/// explains them.
std::string ross_toml(const VibrationSettings& settings, const std::vector<LinearFoils>& all, std::string_view run_id);

}  // namespace bumpfoil
