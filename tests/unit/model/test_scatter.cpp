#include "bumpfoil/model/scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

TEST(Scatter, NormalQuantilesAreThoseOfTables) {
  // From an independent implementation by Wichura (AS 241), statistics.NormalDist of Python.
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.025), -1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-9), -5.997807015007686, 1e-13);
  EXPECT_NEAR(normal_quantile(0x1p-53), -8.209536151601387, 1e-13);
  EXPECT_NEAR(normal_quantile(0.5), 0.0, 1e-16);
}

TEST(Scatter, NormalQuantilesInvertTheProbability) {
  // Three units in the last place: round-off of p, and that of z times the relative slope of p, for tails |z| < 8.3.
  for (double p = 0x1p-53; p < 0.5; p *= 1.37) {
    const double z = normal_quantile(p);
    EXPECT_NEAR(normal_probability(z) / p, 1.0, 3e-16 * (1.0 + z * z)) << p;
    EXPECT_NEAR(normal_quantile(1.0 - p), -normal_quantile(1.0 - (1.0 - p)), 1e-15 * (1.0 + z * z)) << p;
  }
}

TEST(Scatter, QuantilesOfEveryDistribution) {
  const Distribution normal{.kind = DistributionKind::normal, .sigma = 2.0};
  EXPECT_EQ(quantile(normal, 0.3), 2.0 * normal_quantile(0.3));
  const Distribution uniform{.kind = DistributionKind::uniform, .lower = -1.0, .upper = 3.0};
  EXPECT_EQ(quantile(uniform, 0.25), 0.0);
  const Distribution table{.kind = DistributionKind::table, .values = {5.0, 7.0, 6.0}};
  EXPECT_EQ(quantile(table, 0.1), 5.0);
  EXPECT_EQ(quantile(table, 0.5), 7.0);
  EXPECT_EQ(quantile(table, std::nextafter(1.0, 0.0)), 6.0);
}

TEST(Scatter, TruncationKeepsShareAndBounds) {
  for (const auto& [lower, upper] : {std::pair{-1.0, 4.0}, std::pair{-4.0, 1.0}, std::pair{12.0, 16.0}}) {
    const Distribution cut{.kind = DistributionKind::truncated_normal, .sigma = 2.0, .lower = lower, .upper = upper};
    double before = lower;
    for (const double p : {1e-15, 0.1, 0.5, 0.9, 1.0 - 1e-15}) {
      const double x = quantile(cut, p);
      EXPECT_GE(x, before);
      EXPECT_LE(x, upper);
      before = x;
      // The probability below x relative to that between the bounds, from the tail that keeps its digits.
      const auto tail = [](double y) { return normal_probability(-y / 2.0); };
      EXPECT_NEAR((tail(lower) - tail(x)) / (tail(lower) - tail(upper)), p, 1e-12) << lower;
    }
  }
}

TEST(Scatter, NumbersAreFoundInTheCase) {
  Case input = reference_case();
  double added = 1e-6;
  for (const ScatteredNumber& number : scattered_numbers()) number.add(input, added *= 2.0);
  const Case reference = reference_case();
  EXPECT_DOUBLE_EQ(input.bump_foil.thickness.values.front(), reference.bump_foil.thickness.values.front() + 2e-6);
  EXPECT_DOUBLE_EQ(input.top_foil.thickness, reference.top_foil.thickness + 4e-6);
  EXPECT_DOUBLE_EQ(input.bump_foil.length.values.front(), reference.bump_foil.length.values.front() + 8e-6);
  EXPECT_DOUBLE_EQ(input.friction.top_bump, reference.friction.top_bump + 16e-6);
  EXPECT_DOUBLE_EQ(input.friction.bump_sleeve, reference.friction.bump_sleeve + 32e-6);
  EXPECT_DOUBLE_EQ(input.bearing.radial_clearance, reference.bearing.radial_clearance + 64e-6);
}

TEST(Scatter, DeviationsOfFoilsAreThoseOfAllTheirBumps) {
  Case input = reference_case();
  input.bump_foil.thickness = PerBump(0.1e-3, 0.12e-3, Grading::geometric);
  input.bump_foil.sections = {{.from = 3, .to = 4, .thickness = 0.2e-3}, {.from = 5, .to = 5, .length = 3.2e-3}};
  const std::vector<BumpShape> before = nominal_bumps(input.bump_foil);
  for (const ScatteredNumber& number : scattered_numbers()) number.add(input, 1e-6);
  const std::vector<BumpShape> after = nominal_bumps(input.bump_foil);
  for (std::size_t n = 0; n < before.size(); ++n) {
    EXPECT_NEAR(after[n].thickness - before[n].thickness, 1e-6, 1e-18) << n;
    EXPECT_NEAR(after[n].half_length - before[n].half_length, 0.5e-6, 1e-18) << n;
  }
}

}  // namespace
}  // namespace bumpfoil
