#include <gtest/gtest.h>

#include <numbers>

#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Hundreds of bumps touch the journal in one increment: without halving, and with no more work per increment than the
/// interior point needs for a few bumps, 10 to 40 steps of two solves if everything changes and none if nothing does.
/// Measured: 19 to 40 solves per increment.
void expect_long_solved(const Case& input) {
  const Cycle cycle = run_single_cycle(input, input.settings.get<CycleSettings>().directions.front());
  ASSERT_EQ(first_failure(cycle), "");
  EXPECT_EQ(cycle.substeps, 0);
  EXPECT_LE(cycle.cost.iterations, 50 * cycle.due);
  EXPECT_GT(cycle.turning_point->max_force, 0.0);
}

TEST(LongBearings, ThousandBumpsInTwoSteps) {
  expect_long_solved(long_bearing(1000, 2));
}

/// Contact and separation zone by zone.
TEST(LongBearings, FiveHundredBumpsInTenSteps) {
  expect_long_solved(long_bearing(500, 10));
}

TEST(LongBearings, AgainstTheWeldWithStrongFriction) {
  Case input = long_bearing(500, 3);
  input.friction = {.top_bump = 0.5, .bump_sleeve = 0.5};
  input.settings.get<CycleSettings>().directions = {std::numbers::pi};
  expect_long_solved(input);
}

/// Unloaded frames bend more easily than trusses, and wrong modes travel far: with only the rounds of mode changes that
/// short foils need, these increments had to be halved, and those of 10,000 bumps failed.
TEST(LongBearings, FramesOfTwoThousandBumpsInTwoSteps) {
  Case input = long_bearing(2000, 2);
  input.bump_foil.model = BumpFoilModel::frame;
  for (const double direction : {0.5 * std::numbers::pi, std::numbers::pi}) {
    const Cycle cycle = run_single_cycle(input, direction);
    EXPECT_EQ(first_failure(cycle), "") << direction;
    EXPECT_EQ(cycle.substeps, 0) << direction;
  }
}

}  // namespace
}  // namespace bumpfoil
