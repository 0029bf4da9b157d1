#include "bumpfoil/motion/response.hpp"

#include <cmath>

#include "bumpfoil/core/assert.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {

std::optional<Eigen::VectorXcd> linear_response(const Rotor& rotor, const std::vector<CarryingBearing>& bearings,
                                                const Eigen::VectorXcd& force, std::complex<double> rate, bool stuck) {
  BUMPFOIL_ASSERT(!bearings.empty() && bearings.size() == rotor.bearings.size());
  const double speed = bearings.front().state.speed;
  Eigen::MatrixXcd D = rate * rate * rotor.mass + rate * (speed * rotor.gyroscopic + rotor.damping) + rotor.stiffness;
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const auto impedance = bearings[i].stepper.impedances(bearings[i].state, {rate}, stuck);
    if (!impedance) return std::nullopt;
    D += rotor.bearings[i].on_rotor(impedance->front());
  }
  return solve(D, force);
}

EllipticOrbit elliptic_orbit(const Eigen::Vector2cd& amplitudes, double speed) {
  // x + i y of two circles, one for each sense: conj(X - i Y) turns from Y to X, X + i Y from X to Y.
  const std::complex<double> i(0.0, 1.0);
  const double positive = 0.5 * std::abs(amplitudes.x() + i * amplitudes.y());
  const double negative = 0.5 * std::abs(amplitudes.x() - i * amplitudes.y());
  return {.major = positive + negative, .minor = std::copysign(1.0, speed) * (positive - negative)};
}

}  // namespace bumpfoil
