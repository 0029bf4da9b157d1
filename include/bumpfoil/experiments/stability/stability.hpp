#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "bumpfoil/bearing/film_bearing.hpp"
#include "bumpfoil/experiments/rotor_settings.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/motion/speed_map.hpp"

namespace bumpfoil {

/// Table [stability] of a case.
struct StabilitySettings {
  std::vector<double> speeds{};  ///< rad/s

  bool operator==(const StabilitySettings&) const = default;
};

/// Free motions of rotor, film and foils over the speeds of a case, and their onsets.
struct StabilityResult {
  SharedFilmBearing bearing;           ///< each of those that carry the rotor
  Rotor rotor;                         ///< as it was reduced
  double reduction_error{};            ///< see ReducedRotor
  std::vector<Eigen::Vector2d> loads;  ///< on the bearings, N
  SpeedMap map;

  [[nodiscard]] bool converged() const;
};

/// A run that ended before its first speed.
/// @throws Error (input) as run_stability() does
StabilityResult stability_not_begun(const Case& input);

/// Follows the rotor of a case over its speeds, see map_speeds().
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) if the case cannot be built, or has no rotor or speeds
StabilityResult run_stability(const Case& input, const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
