#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/vibration/vibration.hpp"

namespace bumpfoil {

/// Frequencies (rad/s, increasing) of coefficients for rotor dynamics, which interpolates between them: those of the
/// case if there are at least five; otherwise these and nine at equal ratios from half of the lowest to twice the
/// highest. Damping falls as 1/omega, which a curve through fewer points would miss.
std::vector<double> exported_frequencies(std::vector<double> frequencies);

/// Contents of coefficients.toml: for each load and amplitude with all coefficients known, the arguments of the
/// constructor of ROSS's BearingElement, with comments on their meaning and limits. See docs/rotor_dynamics.md.
std::string ross_toml(const VibrationSettings& settings, const std::vector<LinearFoils>& all, std::string_view run_id);

}  // namespace bumpfoil
