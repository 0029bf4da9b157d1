#include "bumpfoil/rotor/unbalance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bumpfoil {
namespace {

/// An unbalance that turns with the rotor, in either sense, in a plane away from the middle.
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

/// The unbalance force is an inertia force: -U d^2/dt^2 (cos a, sin a), by differences of angles a(t).
TEST(UnbalanceForce, IsTheInertiaOfAPlaceOnARotorThatAccelerates) {
  const Rotor rotor = make_rigid_rotor(
      {.mass = 2.2, .transverse_inertia = 9e-3, .polar_inertia = 1.1e-3, .bearings = {-0.07, 0.09}, .planes = {0.05}});
  const RotorStation& plane = rotor.stations.front();
  const Unbalance unbalance{.amount = 1.5e-6, .phase = 0.8};
  constexpr double speed = -30.0;
  constexpr double acceleration = 700.0;
  const auto angle = [](double t) { return 0.4 + speed * t + 0.5 * acceleration * t * t; };
  const auto outward = [&](double t) {
    const double a = angle(t) + unbalance.phase;
    return Eigen::Vector2d(std::cos(a), std::sin(a));
  };
  constexpr double h = 1e-4;
  const Eigen::Vector2d second = (outward(h) - 2.0 * outward(0.0) + outward(-h)) / (h * h);
  const Eigen::VectorXd force = unbalance_force(plane, unbalance, angle(0.0), speed, acceleration);
  const Eigen::Vector4d expected = -unbalance.amount * (plane.motion.transpose() * second);
  EXPECT_LT((force - expected).norm(), 1e-5 * expected.norm());  // truncation h^2, and round-off over h^2
  const Eigen::VectorXd even = unbalance_force(plane, unbalance, angle(0.0), speed, 0.0);
  const Eigen::VectorXcd linear = unbalance_force(plane, unbalance, speed);
  EXPECT_LT((even - (linear * std::polar(1.0, -angle(0.0))).real()).norm(), 1e-13 * even.norm());
}

/// A rotor of 2 kg at 60,000 rpm and G 2.5: e = 0.4 um.
TEST(UnbalanceOfGrade, IsWhatTheGradeAllows) {
  const double speed = 2000.0 * M_PI;
  EXPECT_NEAR(unbalance_of_grade(2.5e-3, 2.0, speed), 2.0 * 0.39789e-6, 1e-10);
  EXPECT_EQ(unbalance_of_grade(2.5e-3, 2.0, -speed), unbalance_of_grade(2.5e-3, 2.0, speed));
}

}  // namespace
}  // namespace bumpfoil
