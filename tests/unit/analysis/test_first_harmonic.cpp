#include "bumpfoil/analysis/first_harmonic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace bumpfoil {
namespace {

constexpr double pi = std::numbers::pi;

/// Points of one loop about `middle`, from there up, down and back, so many per quarter. The second argument of `force`
/// says whether the displacement rises.
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
    // The displacement is known to 1e-16 of 40 um, the force to that of 50 N.
    const double rounding = 1e-14 * (50.0 / amplitude + 3e6 * 40e-6 / amplitude);
    EXPECT_NEAR(harmonic.stiffness.x(), 3e6, rounding);
    EXPECT_NEAR(harmonic.stiffness.y(), -1e6, rounding);
    EXPECT_NEAR(harmonic.loss.norm(), 0.0, rounding);
    EXPECT_NEAR(harmonic.residual, 0.0, rounding / 3e6);
  }
}

TEST(FirstHarmonic, OfASliderBehindASpringIsTheClassicOne) {
  // Force k, until the slider yields at f: Caughey's bilinear hysteresis without its second spring. With
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
  // Roundings.
  EXPECT_NEAR(harmonic.stiffness.x(), k / pi * (theta - 0.5 * std::sin(2.0 * theta)), 1e-13 * k);
  EXPECT_NEAR(harmonic.loss.x(), 4.0 * f * (X - slip) / (pi * X * X), 1e-13 * k);
  EXPECT_EQ(harmonic.stiffness.y(), 0.0);
}

TEST(FirstHarmonic, OfASliderAloneIsASquareWave) {
  const auto slider = [](double, bool rising) { return Eigen::Vector2d(0.0, rising ? 5.0 : -5.0); };
  const FirstHarmonic harmonic = first_harmonic(loop_of(slider, 0.0, 2e-6, 3));
  EXPECT_NEAR(harmonic.stiffness.norm(), 0.0, 1e-9);  // N/m, roundings of 5 N over 2 um
  EXPECT_NEAR(harmonic.loss.y(), 4.0 * 5.0 / (pi * 2e-6), 1e-7);
  // Of its norm 8/pi^2 is in the first harmonic, squared.
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
      EXPECT_NEAR(last / error, 4.0, 0.2) << steps;  // in the limit
    }
    EXPECT_NEAR(harmonic.residual, 1.0 / 3.0, 2.0 / (steps * steps));
    last = error;
  }
  EXPECT_LT(last, 3e-3);
}

TEST(FirstHarmonic, OfNoForceHasNoResidual) {
  const auto nothing = [](double, bool) { return Eigen::Vector2d(0.0, 0.0); };
  const FirstHarmonic harmonic = first_harmonic(loop_of(nothing, 0.0, 1e-6, 4));
  EXPECT_EQ(harmonic.stiffness, Eigen::Vector2d(0.0, 0.0));
  EXPECT_TRUE(std::isnan(harmonic.residual));
}

}  // namespace
}  // namespace bumpfoil
