#include "bumpfoil/motion/response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/rotor/unbalance.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// The response to slow forces is governed by stiffness, to fast ones by mass.
TEST(LinearResponse, IsThatOfStiffnessAndOfMass) {
  FilmStepper stepper(film_reference_bearing({4, 3}, 0.1));
  const BearingState state = state_under(stepper, {30.0, 0.0}, speed_of_rpm(-45000.0));
  const Rotor rotor = make_point_mass(2.0);
  const Eigen::Vector2cd force(3.0, std::complex<double>(0.0, -1.0));
  for (const bool stuck : {false, true}) {
    const auto slow = linear_response(rotor, {{stepper, state}}, force, 0.0, stuck);
    const auto stiffness = stepper.stiffness(state, stuck);
    ASSERT_TRUE(slow && stiffness);
    EXPECT_LT((*stiffness * *slow - force).norm(), 1e-9);
    const std::complex<double> rate(0.0, 1e7);
    const auto fast = linear_response(rotor, {{stepper, state}}, force, rate, stuck);
    ASSERT_TRUE(fast);
    // A film that cannot flow has about 1e8 N/m; m nu^2 is 2e14 N/m.
    EXPECT_LT((rate * rate * 2.0 * *fast - force).norm(), 1e-4);
  }
}

/// Amplitudes (um) and phases (deg) along X and Y of 1 kg with its centre of mass 1 um from the axis, under 100 N at
/// -45,000 rpm.
Eigen::Vector4d response_of(double friction, bool stuck) {
  FilmStepper stepper(film_reference_bearing({6, 8}, friction));
  const double speed = speed_of_rpm(-45000.0);
  const BearingState state = state_under(stepper, {100.0, 0.0}, speed);
  const Rotor rotor = make_point_mass(1.0);
  const auto y =
      linear_response(rotor, {{stepper, state}}, unbalance_force(rotor.bearings.front(), {.amount = 1e-6}, speed),
                      {0.0, std::abs(speed)}, stuck);
  EXPECT_TRUE(y.has_value());
  const auto degrees = [](Complex z) { return std::arg(z) * 180.0 / std::numbers::pi; };
  return {1e6 * std::abs((*y)[0]), 1e6 * std::abs((*y)[1]), degrees((*y)[0]), degrees((*y)[1])};
}

/// Values of an independent program. With friction, states depend on the increments leading to them: 1 %.
TEST(LinearResponse, IsThatOfThePrototype) {
  const Eigen::Vector4d smooth = response_of(0.0, false);
  EXPECT_NEAR(smooth[0], 1.32838, 1e-5);
  EXPECT_NEAR(smooth[1], 1.17106, 1e-5);
  EXPECT_NEAR(smooth[2], 179.10, 0.01);
  EXPECT_NEAR(smooth[3], -85.78, 0.01);
  const Eigen::Vector4d stuck = response_of(0.1, true);
  EXPECT_NEAR(stuck[0], 1.7216, 0.02);
  EXPECT_NEAR(stuck[1], 1.2178, 0.02);
}

/// Far above its critical speed a rotor spins about its centre of mass.
TEST(LinearResponse, CentresAHeavyRotor) {
  FilmStepper stepper(film_reference_bearing({4, 4}));
  const double speed = speed_of_rpm(-45000.0);
  const BearingState state = state_under(stepper, {20.0, 0.0}, speed);
  const double mass = 1e3;
  const Rotor rotor = make_point_mass(mass);
  const auto y =
      linear_response(rotor, {{stepper, state}},
                      unbalance_force(rotor.bearings.front(), {.amount = 1e-6 * mass}, speed), {0.0, std::abs(speed)});
  ASSERT_TRUE(y.has_value());
  EXPECT_NEAR(std::abs((*y)[0] + 1e-6), 0.0, 1e-9);
  EXPECT_NEAR(std::abs((*y)[1] - Complex(0.0, -1e-6)), 0.0, 1e-9);
}

TEST(EllipticOrbit, HasItsAxesAndSense) {
  // An ellipse with the semi-axes 3 and 1, turned by 0.4, from X to Y.
  const double turn = 0.4;
  const Complex i(0.0, 1.0);
  const Eigen::Vector2cd forward(3.0 * std::cos(turn) + i * std::sin(turn), 3.0 * std::sin(turn) - i * std::cos(turn));
  for (const double speed : {100.0, -100.0}) {
    const EllipticOrbit orbit = elliptic_orbit(forward, speed);
    EXPECT_NEAR(orbit.major, 3.0, 1e-12);
    EXPECT_NEAR(orbit.minor, speed > 0.0 ? 1.0 : -1.0, 1e-12);
  }
}

}  // namespace
}  // namespace bumpfoil
