#include "bumpfoil/rotor/unbalance.hpp"

#include <cmath>
#include <complex>

namespace bumpfoil {

double unbalance_of_grade(double grade, double mass, double speed) {
  return grade * mass / std::abs(speed);
}

Eigen::VectorXcd unbalance_force(const RotorStation& plane, const Unbalance& unbalance, double speed) {
  const double sense = speed < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector2cd along(1.0, std::complex<double>(0.0, -sense));
  const std::complex<double> size = std::polar(unbalance.amount * speed * speed, sense * unbalance.phase);
  return size * (plane.motion.transpose() * along);
}

Eigen::VectorXd unbalance_force(const RotorStation& plane, const Unbalance& unbalance, double angle, double speed,
                                double acceleration) {
  const double a = angle + unbalance.phase;
  const Eigen::Vector2d outward(std::cos(a), std::sin(a));
  const Eigen::Vector2d along(-std::sin(a), std::cos(a));
  return unbalance.amount * (plane.motion.transpose() * (speed * speed * outward - acceleration * along));
}

}  // namespace bumpfoil
