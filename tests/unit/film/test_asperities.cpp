#include "bumpfoil/film/asperities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bumpfoil {
namespace {

/// F_n(u) by the double exponential rule over s - u = exp(pi/2 sinh(x)), an independent quadrature.
double statistical_integral(double n, double u) {
  constexpr double h = 1.0 / 64.0;
  double sum = 0.0;
  for (int i = -256; i <= 160; ++i) {
    const double x = h * i;
    const double y = std::exp(0.5 * std::numbers::pi * std::sinh(x));  // s - u
    const double weight = 0.5 * std::numbers::pi * std::cosh(x) * y;
    sum += h * weight * std::pow(y, n) * std::exp(-0.5 * (u + y) * (u + y));
  }
  return sum / std::sqrt(2.0 * std::numbers::pi);
}

TEST(Asperities, IntegralIsThatOfAnotherQuadrature) {
  // 2^(3/4) Gamma(7/4) / sqrt(2 pi)
  EXPECT_NEAR(greenwood_tripp(0.0).value, std::pow(2.0, 0.75) * std::tgamma(1.75) / std::sqrt(2.0 * std::numbers::pi),
              1e-14);
  EXPECT_NEAR(greenwood_tripp(0.0).value, 0.616634, 5e-7);
  for (const double u : {0.0, 0.1, 0.7, 1.5, 3.0, 4.5, 6.0, 10.0}) {
    const GreenwoodTripp found = greenwood_tripp(u);
    EXPECT_NEAR(found.value / statistical_integral(2.5, u), 1.0, 1e-11) << u;
    EXPECT_NEAR(found.slope / (-2.5 * statistical_integral(1.5, u)), 1.0, 1e-11) << u;
  }
  EXPECT_EQ(greenwood_tripp(100.0).value, 0.0);
}

TEST(Asperities, PressureFallsByItsSlope) {
  const Asperities rough{.pressure_factor = 2e8, .roughness = 0.3e-6, .friction = 0.2};
  EXPECT_DOUBLE_EQ(rough.pressure(0.6e-6), 2e8 * greenwood_tripp(2.0).value);
  for (const double h : {0.05e-6, 0.4e-6, 1.1e-6}) {
    const double d = 1e-4 * rough.roughness;
    const double difference = (rough.pressure(h + d) - rough.pressure(h - d)) / (2.0 * d);
    EXPECT_NEAR(rough.slope(h) / difference, 1.0, 1e-7);  // truncation error of the difference: (d / sigma)^2
    EXPECT_LT(rough.slope(h), 0.0);
  }
}

TEST(Asperities, HoldWhatTheirPressureDoes) {
  const Asperities rough{.pressure_factor = 2e8, .roughness = 0.3e-6, .friction = 0.2};
  for (const double h : {0.0, 0.4e-6, 1.1e-6}) {
    const double expected = 2.0 / 7.0 * 2e8 * 0.3e-6 * statistical_integral(3.5, h / 0.3e-6);
    EXPECT_NEAR(rough.energy(h) / expected, 1.0, 1e-10);
  }
}

TEST(Asperities, PressureFactorIsMadeOfPeaks) {
  // eta beta sigma = 0.05, sigma / beta = 0.01, E* = 100 GPa
  const double expected = 16.0 * std::sqrt(2.0) / 15.0 * std::numbers::pi * 0.0025 * 0.1 * 1e11;
  EXPECT_NEAR(asperity_pressure_factor(0.1e-6, 0.05 / 1e-12, 10e-6, 1e11), expected, 1e-9 * expected);
}

}  // namespace
}  // namespace bumpfoil
