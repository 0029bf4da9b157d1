#include <gtest/gtest.h>

#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Cases `first` .. `first + 49`: every increment solved within its bounds and none halved.
void expect_all_solved(std::uint64_t first) {
  for (std::uint64_t number = first; number < first + 50; ++number) {
    const Case input = random_case(number);
    const Cycle cycle = run_single_cycle(input, input.cycle.directions.front());
    EXPECT_EQ(first_failure(cycle), "") << input.title;
    EXPECT_EQ(cycle.substeps(), 0) << input.title;
  }
}

// Two hundred cases in four tests that run side by side.
TEST(RandomBearings, AreSolvedFirstQuarter) {
  expect_all_solved(0);
}
TEST(RandomBearings, AreSolvedSecondQuarter) {
  expect_all_solved(50);
}
TEST(RandomBearings, AreSolvedThirdQuarter) {
  expect_all_solved(100);
}
TEST(RandomBearings, AreSolvedFourthQuarter) {
  expect_all_solved(150);
}

TEST(RandomBearings, AreTheSameForTheSameNumberAndDifferOtherwise) {
  EXPECT_EQ(random_case(7).bump_foil.height_errors, random_case(7).bump_foil.height_errors);
  EXPECT_NE(random_case(7).bump_foil.height_errors, random_case(8).bump_foil.height_errors);
  EXPECT_EQ(random_case(7).cycle.directions, random_case(7).cycle.directions);
}

}  // namespace
}  // namespace bumpfoil
