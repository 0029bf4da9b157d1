#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/motion/speed_map.hpp"

namespace bumpfoil {

/// Table [rotor] of a case: what two equal bearings carry, or, with inertias and places of bearings, a rigid rotor on
/// two of them.
struct RotorSettings {
  double mass{};                               ///< of the whole rotor, kg
  std::vector<double> gravity{0.0, -9.81};     ///< along X and Y, m/s^2
  std::optional<double> transverse_inertia{};  ///< kg m^2
  std::optional<double> polar_inertia{};       ///< kg m^2
  std::vector<double> bearings{};              ///< z of the bearings from the centre of mass, m

  bool operator==(const RotorSettings&) const = default;
  /// With places of bearings.
  [[nodiscard]] bool tilts() const { return !bearings.empty(); }
};

/// Table [stability] of a case.
struct StabilitySettings {
  std::vector<double> speeds{};  ///< rad/s

  bool operator==(const StabilitySettings&) const = default;
};

/// The rotor of a case.
Rotor rotor_of(const RotorSettings& settings);

/// Free motions of rotor, film and foils over the speeds of a case, and their onsets.
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) if the case cannot be built
SpeedMap run_stability(const Case& input, const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
