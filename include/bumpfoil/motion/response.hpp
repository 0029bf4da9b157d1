#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "bumpfoil/motion/whirl.hpp"

namespace bumpfoil {

/// Linear response y = Re(Y e^{s t}) of a rotor on its bearings to forces Re(F e^{s t}), about states that all turn at
/// one speed Omega:
///
///     (M s^2 + (Omega G + C) s + K + sum B_i^T Z_i(s) B_i) Y = F
///
/// That to an unbalance has s = i |Omega|, see unbalance_force().
/// @param force  F, N, on the unknowns of the rotor
/// @param rate   s, 1/s, its real part not negative
/// @param stuck  slipping contacts stick, as in an orbit so small that none slips
/// @return Y; nothing if the modes of contacts leave a singular system
std::optional<Eigen::VectorXcd> linear_response(const Rotor& rotor, const std::vector<CarryingBearing>& bearings,
                                                const Eigen::VectorXcd& force, std::complex<double> rate,
                                                bool stuck = false);

/// An elliptic orbit x = Re(X e^{i |Omega| t}), y = Re(Y e^{i |Omega| t}).
struct EllipticOrbit {
  double major{};  ///< semi-axis, m
  double minor{};  ///< semi-axis, m; negative where the orbit is gone round against the rotation
};

/// @param speed  Omega, for its sign
EllipticOrbit elliptic_orbit(const Eigen::Vector2cd& amplitudes, double speed);

}  // namespace bumpfoil
