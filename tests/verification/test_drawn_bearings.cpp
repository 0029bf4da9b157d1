#include <gtest/gtest.h>

#include "support/drawn_bearings.hpp"

namespace bumpfoil {
namespace {

/// The first of the bearings of docs/verification/drawn_bearings.md.
TEST(DrawnBearings, AreResolvedAndNoneIsWronglyCalledConverged) {
  for (std::uint64_t number = 0; number < 100; ++number) {
    const Case input = drawn_bearing(number);
    const BearingVerdict verdict = judge_bearing(input, number % 10 == 0);
    for (const SolverVerdict& solver : {verdict.newton, verdict.events}) {
      EXPECT_EQ(solver.status, Status::converged) << input.title;
      EXPECT_EQ(solver.wrong, "") << input.title;
    }
    EXPECT_EQ(verdict.newton.substeps, 0) << input.title;
    EXPECT_EQ(verdict.apart.has_value(), number % 10 == 0);
    if (verdict.apart.value_or(0.0) > agreement) {
      EXPECT_LE(verdict.apart_refined.value_or(1.0), agreement) << input.title;
    }
  }
}

TEST(DrawnBearings, AreFunctionsOfTheirNumber) {
  EXPECT_EQ(drawn_bearing(7), drawn_bearing(7));
  EXPECT_NE(drawn_bearing(7).bump_foil.height_errors, drawn_bearing(8).bump_foil.height_errors);
  const Case input = drawn_bearing(9);
  EXPECT_EQ(input.friction.top_bump, input.friction.bump_sleeve);  // every third
}

}  // namespace
}  // namespace bumpfoil
