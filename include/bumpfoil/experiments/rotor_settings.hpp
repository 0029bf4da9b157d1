#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/rotor/rotor.hpp"
#include "bumpfoil/rotor/shaft.hpp"

namespace bumpfoil {

/// Table [rotor] of a case: half of a mass on each of two equal bearings; with places of the bearings and inertias, a
/// rigid rotor on them; with pieces of a shaft, a flexible one.
struct RotorSettings {
  std::optional<double> mass{};                ///< of the whole rotor, kg; that of a shaft follows from its pieces
  std::vector<double> gravity{0.0, -9.81};     ///< along X and Y, m/s^2
  std::optional<double> transverse_inertia{};  ///< kg m^2
  std::optional<double> polar_inertia{};       ///< kg m^2
  /// z of the bearings, m: from the centre of mass of a rigid rotor, from the begin of a shaft.
  std::vector<double> bearings{};
  std::vector<ShaftSection> shaft{};
  std::vector<ShaftDisc> disks{};

  bool operator==(const RotorSettings&) const = default;
  [[nodiscard]] bool is_flexible() const { return !shaft.empty(); }
  [[nodiscard]] bool tilts() const { return is_flexible() || !bearings.empty(); }
  [[nodiscard]] Eigen::Vector2d gravity_vector() const { return {gravity[0], gravity[1]}; }
};

/// The rotor of a case; a flexible one reduced to the modes that count up to some frequency.
/// @param range  rad/s
ReducedRotor rotor_of(const RotorSettings& settings, double range);

/// The rotor of a case.
/// @throws Error (input) if there is none
const RotorSettings& rotor_settings_of(const Case& input);

}  // namespace bumpfoil
