#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/motion/speed_map.hpp"

namespace bumpfoil {

/// Table [stability] of a case.
struct StabilitySettings {
  static constexpr std::string_view table = "stability";

  std::vector<double> speeds{};  ///< rad/s

  bool operator==(const StabilitySettings&) const = default;
};

/// Free motions of rotor, film and foils over the speeds of a case, and their onsets.
struct StabilityResult {
  Machine machine;
  SpeedMap map;
};

/// A run that ended before its first speed.
/// @throws Error (input) as run_stability() does
StabilityResult stability_not_begun(const Case& input);

/// Follows the rotor of a case over its speeds, see map_speeds().
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) if the case cannot be built, or has no rotor or speeds
StabilityResult run_stability(const Case& input, const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
