#include "bumpfoil/experiments/cycle/first_harmonic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace bumpfoil {
namespace {

using std::numbers::pi;

/// Points of one loop about `middle`, from there up, down and back, `steps` per quarter. The second argument of `force`
/// is true while the displacement increases.
std::vector<LoopPoint> loop_of(const std::function<Eigen::Vector2d(double, bool)>& force, double middle,
                               double amplitude, int steps) {
  std::vector<LoopPoint> loop;
  const auto add = [&](int k, bool rising) {
    const double x = amplitude * k / steps;
    loop.push_back({middle + x, force(x, rising)});
  };
  for (int k = 0; k <= steps; ++k) add(k, true);
  for (int k = steps; k >= -steps; --k) add(k, false);
  for (int k = -steps; k <= 0; ++k) add(k, true);
  return loop;
}

TEST(FirstHarmonic, OfASpringIsTheSpring) {
  const auto spring = [](double x, bool) { return Eigen::Vector2d(50.0 + 3e6 * x, -20.0 - 1e6 * x); };
  for (const double amplitude : {1e-9, 1e-5}) {
    const FirstHarmonic harmonic = first_harmonic(loop_of(spring, 40e-6, amplitude, 7));
    // Displacements have round-off of 1e-16 of 40 um, forces of 50 N.
    const double rounding = 1e-14 * (50.0 / amplitude + 3e6 * 40e-6 / amplitude);
    EXPECT_NEAR(harmonic.stiffness.x(), 3e6, rounding);
    EXPECT_NEAR(harmonic.stiffness.y(), -1e6, rounding);
    EXPECT_NEAR(harmonic.loss.norm(), 0.0, rounding);
    EXPECT_NEAR(harmonic.residual, 0.0, rounding / 3e6);
  }
}

TEST(FirstHarmonic, OfASliderBehindASpringIsTheClassicOne) {
  // Force k until the slider yields at f: Caughey's bilinear hysteresis without its second spring. With
  // cos(theta) = 1 - 2 (f/k)/X the stiffness is (k/pi)(theta - sin(2 theta)/2), the loop 4 f (X - f/k).
  const double k = 2e6;
  const double f = 3.0;
  const double X = 4e-6;
  const double slip = f / k;
  const std::vector<LoopPoint> corners{
      {0.0, {f, 0.0}}, {X, {f, 0.0}}, {X - 2.0 * slip, {-f, 0.0}}, {-X, {-f, 0.0}}, {-X + 2.0 * slip, {f, 0.0}},
      {0.0, {f, 0.0}}};
  const FirstHarmonic harmonic = first_harmonic(corners);
  const double theta = std::acos(1.0 - 2.0 * slip / X);
  // Round-off.
  EXPECT_NEAR(harmonic.stiffness.x(), k / pi * (theta - 0.5 * std::sin(2.0 * theta)), 1e-13 * k);
  EXPECT_NEAR(harmonic.loss.x(), 4.0 * f * (X - slip) / (pi * X * X), 1e-13 * k);
  EXPECT_EQ(harmonic.stiffness.y(), 0.0);
}

TEST(FirstHarmonic, OfASliderAloneIsASquareWave) {
  const auto slider = [](double, bool rising) { return Eigen::Vector2d(0.0, rising ? 5.0 : -5.0); };
  const FirstHarmonic harmonic = first_harmonic(loop_of(slider, 0.0, 2e-6, 3));
  EXPECT_NEAR(harmonic.stiffness.norm(), 0.0, 1e-9);  // N/m, round-off of 5 N over 2 um
  EXPECT_NEAR(harmonic.loss.y(), 4.0 * 5.0 / (pi * 2e-6), 1e-7);
  // The first harmonic contains 8/pi^2 of the squared norm.
  EXPECT_NEAR(harmonic.residual, std::sqrt(pi * pi / 8.0 - 1.0), 1e-12);
}

TEST(FirstHarmonic, ConvergesOnACurvedLoopAsTheSquareOfTheIncrement) {
  // x^3 = (3/4) cos + (1/4) cos(3 tau).
  const auto cube = [](double x, bool) { return Eigen::Vector2d(x * x * x, 0.0); };
  double last = 0.0;
  for (const int steps : {10, 20, 40}) {
    const FirstHarmonic harmonic = first_harmonic(loop_of(cube, 0.0, 2.0, steps));
    const double error = std::abs(harmonic.stiffness.x() - 3.0);
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 4.0, 0.2) << steps;  // asymptotically
    }
    EXPECT_NEAR(harmonic.residual, 1.0 / 3.0, 2.0 / (steps * steps));
    last = error;
  }
  EXPECT_LT(last, 3e-3);
}

/// By hand: F = K x + (H/omega) dx/dt on a circle.
TEST(OrbitHarmonic, OfLinearFoilsHasTheColumnsOfBothMatrices) {
  Eigen::Matrix2d K, H;
  K << 3.0, 0.5, -0.2, 2.0;
  H << 0.4, 0.1, 0.3, 0.7;
  const double radius = 2e-6;
  for (const double sense : {1.0, -1.0}) {
    std::vector<Eigen::Vector2d> forces;
    for (int k = 0; k < 12; ++k) {
      const double tau = 2.0 * std::numbers::pi * k / 12.0;
      const Eigen::Vector2d x(std::cos(tau), sense * std::sin(tau));
      const Eigen::Vector2d rate(-std::sin(tau), sense * std::cos(tau));
      forces.push_back(radius * (K * x + H * rate) + Eigen::Vector2d(100.0, -50.0));
    }
    const FirstHarmonic found = orbit_harmonic(forces, radius);
    EXPECT_LT((found.stiffness - (K.col(0) + sense * H.col(1))).norm(), 1e-7);  // round-off of 100 N over 2e-6 m
    EXPECT_LT((found.loss - (H.col(0) - sense * K.col(1))).norm(), 1e-7);
    EXPECT_LT(found.residual, 1e-7);
  }
}

TEST(OrbitHarmonic, LeavesTheHigherHarmonics) {
  std::vector<Eigen::Vector2d> forces;
  for (int k = 0; k < 24; ++k) {
    const double tau = 2.0 * std::numbers::pi * k / 24.0;
    forces.emplace_back(3.0 * std::cos(tau) + 0.6 * std::cos(3.0 * tau),
                        4.0 * std::sin(tau) - 0.8 * std::sin(2.0 * tau));
  }
  const FirstHarmonic found = orbit_harmonic(forces, 1.0);
  EXPECT_NEAR(found.stiffness.x(), 3.0, 1e-12);
  EXPECT_NEAR(found.loss.y(), -4.0, 1e-12);
  EXPECT_NEAR(found.residual, 1.0 / 5.0, 1e-12);
}

TEST(FirstHarmonic, OfNoForceHasNoResidual) {
  const auto nothing = [](double, bool) { return Eigen::Vector2d(0.0, 0.0); };
  const FirstHarmonic harmonic = first_harmonic(loop_of(nothing, 0.0, 1e-6, 4));
  EXPECT_EQ(harmonic.stiffness, Eigen::Vector2d(0.0, 0.0));
  EXPECT_TRUE(std::isnan(harmonic.residual));
}

}  // namespace
}  // namespace bumpfoil
