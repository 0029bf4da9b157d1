#include "bumpfoil/rotor/unbalance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bumpfoil {
namespace {

/// A heavy place that turns with the rotor, in either sense, at a plane out of the middle.
TEST(UnbalanceForce, TurnsWithTheRotor) {
  const Rotor rotor = make_rigid_rotor(
      {.mass = 2.2, .transverse_inertia = 9e-3, .polar_inertia = 1.1e-3, .bearings = {-0.07, 0.09}, .planes = {0.05}});
  const Unbalance unbalance{.amount = 1.5e-6, .phase = 0.8};
  for (const double speed : {1100.0, -1100.0}) {
    const Eigen::VectorXcd force = unbalance_force(rotor.stations.front(), unbalance, speed);
    for (const double t : {0.0, 1e-3, 2.7e-3}) {
      const std::complex<double> turned = std::polar(1.0, std::abs(speed) * t);
      const double angle = speed * t + unbalance.phase;
      const double size = unbalance.amount * speed * speed;
      const Eigen::Vector4d expected =
          size * Eigen::Vector4d(std::cos(angle), std::sin(angle), 0.05 * std::cos(angle), 0.05 * std::sin(angle));
      EXPECT_LT(((force * turned).real() - expected).norm(), 1e-13 * size);
    }
  }
}

/// A rotor of 2 kg at 60,000 rpm and G 2.5: e = 0.4 um.
TEST(UnbalanceOfGrade, IsWhatTheGradeAllows) {
  const double speed = 2000.0 * M_PI;
  EXPECT_NEAR(unbalance_of_grade(2.5e-3, 2.0, speed), 2.0 * 0.39789e-6, 1e-10);
  EXPECT_EQ(unbalance_of_grade(2.5e-3, 2.0, -speed), unbalance_of_grade(2.5e-3, 2.0, speed));
}

}  // namespace
}  // namespace bumpfoil
