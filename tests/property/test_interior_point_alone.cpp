#include <gtest/gtest.h>

#include "support/bearing_cases.hpp"
#include "support/interior_point_alone.hpp"

namespace bumpfoil {
namespace {

void expect_cycle_solved_alone(const Case& input, int increments) {
  const InteriorPointRun run = run_interior_point_alone(input, increments);
  EXPECT_EQ(run.failure, "");
  EXPECT_GT(run.steps, 0) << input.title;
}

TEST(InteriorPointAlone, SolvesRandomBearings) {
  for (std::uint64_t number = 0; number < 60; ++number) expect_cycle_solved_alone(random_case(number), 6);
}

/// One coefficient of friction at both interfaces, clearances of -10 um to 50 um.
void expect_solved_with_friction(std::uint64_t first, double friction) {
  for (std::uint64_t number = first; number < first + 60; ++number) {
    Case input = random_case(number);
    input.friction = {.top_bump = friction, .bump_sleeve = friction};
    input.bearing.radial_clearance = -10e-6 + 60e-6 * static_cast<double>(number - first) / 59.0;
    expect_cycle_solved_alone(input, 4);
  }
}

TEST(InteriorPointAlone, SolvesThemWithStrongFrictionAndClearancesOfAnySign) {
  expect_solved_with_friction(100, 0.5);
}

TEST(InteriorPointAlone, SolvesThemWithHardlyAnyFriction) {
  expect_solved_with_friction(100, 1e-12);
}

TEST(InteriorPointAlone, SolvesThemWithTheFrame) {
  for (std::uint64_t number = 200; number < 230; ++number) {
    Case input = random_case(number);
    input.bump_foil.model = BumpFoilModel::frame;
    expect_cycle_solved_alone(input, 4);
  }
}

}  // namespace
}  // namespace bumpfoil
