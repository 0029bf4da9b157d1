#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "bumpfoil/motion/whirl.hpp"
#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// Small forced motion y = Re(Y e^{i |Omega| t}) of a rotor on its bearings about their states,
///
///     D(i |Omega|) Y = F,
///
/// D as of Whirl. Contacts keep their modes, or all closed ones stick, as they do under a small unbalance after some
/// revolutions.
/// @param force  F, N, see unbalance_force()
/// @return Y; nothing if the modes leave a singular system
std::optional<Eigen::VectorXcd> unbalance_response(const Rotor& rotor, const std::vector<CarryingBearing>& bearings,
                                                   const Eigen::VectorXcd& force, bool stuck = false);

/// An elliptic orbit x = Re(X e^{i |Omega| t}), y = Re(Y e^{i |Omega| t}).
struct EllipticOrbit {
  double major{};  ///< semi-axis, m
  double minor{};  ///< semi-axis, m; negative where the orbit is gone round against the rotation
};

/// @param speed  Omega, for its sign
EllipticOrbit elliptic_orbit(const Eigen::Vector2cd& amplitudes, double speed);

}  // namespace bumpfoil
