#include <gtest/gtest.h>

#include "support/bearing_cases.hpp"
#include "support/interior_point_alone.hpp"

namespace bumpfoil {
namespace {

/// Random bearings with friction up to `most_friction`; every second has a clearance of -10 um to 50 um.
/// @return increments
int count_solved(std::uint64_t first, std::uint64_t last, double most_friction) {
  int increments = 0;
  for (std::uint64_t number = first; number < last; ++number) {
    Case input = random_case(number);  // friction up to 0.5
    input.friction.top_bump *= most_friction / 0.5;
    input.friction.bump_sleeve *= most_friction / 0.5;
    if (number % 2 == 1) input.bearing.radial_clearance = -10e-6 + 60e-6 * static_cast<double>(number % 100) / 99.0;
    const InteriorPointRun run = run_interior_point_alone(input, 10);
    EXPECT_EQ(run.failure, "");
    increments += run.increments;
  }
  return increments;
}

/// These numbers appear in docs/theory/algorithms.md.
TEST(ManyInteriorPoints, SolveRandomBearings) {
  EXPECT_EQ(count_solved(10000, 14000, 0.5), 84000);
}

TEST(ManyInteriorPoints, SolveThemWithTwiceTheFriction) {
  EXPECT_EQ(count_solved(20000, 22000, 1.0), 42000);
}

}  // namespace
}  // namespace bumpfoil
