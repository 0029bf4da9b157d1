#include "bumpfoil/motion/unbalance_response.hpp"

#include <Eigen/LU>
#include <cmath>
#include <complex>

namespace bumpfoil {

std::optional<Eigen::VectorXcd> unbalance_response(const Rotor& rotor, const std::vector<CarryingBearing>& bearings,
                                                   const Eigen::VectorXcd& force, bool stuck) {
  const double speed = bearings.front().state.speed;
  const std::complex<double> rate(0.0, std::abs(speed));
  Eigen::MatrixXcd dynamic_stiffness = rate * rate * rotor.mass + rate * (speed * rotor.gyroscopic + rotor.damping) +
                                       rotor.stiffness.cast<std::complex<double>>();
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const auto impedance = bearings[i].stepper.impedance(bearings[i].state, {rate}, stuck);
    if (!impedance) return std::nullopt;
    const Eigen::MatrixXd& motion = rotor.bearings[i].motion;
    dynamic_stiffness += motion.transpose() * impedance->at(rate) * motion;
  }
  return dynamic_stiffness.partialPivLu().solve(force);
}

EllipticOrbit elliptic_orbit(const Eigen::Vector2cd& amplitudes, double speed) {
  // x + i y of two circles, one for each sense: conj(X - i Y) turns from Y to X, X + i Y from X to Y.
  const std::complex<double> i(0.0, 1.0);
  const double positive = 0.5 * std::abs(amplitudes.x() + i * amplitudes.y());
  const double negative = 0.5 * std::abs(amplitudes.x() - i * amplitudes.y());
  return {.major = positive + negative, .minor = std::copysign(1.0, speed) * (positive - negative)};
}

}  // namespace bumpfoil
