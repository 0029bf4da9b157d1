#include <gtest/gtest.h>

#include <numbers>

#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

TEST(LongestBearings, FramesOfTenThousandBumpsInTwoSteps) {
  Case input = long_bearing(10000, 2);
  input.bump_foil.model = BumpFoilModel::frame;
  for (const double direction : {0.0, 0.5 * std::numbers::pi, std::numbers::pi, 1.5 * std::numbers::pi}) {
    EXPECT_EQ(first_failure(run_single_cycle(input, direction)), "") << direction;
  }
}

}  // namespace
}  // namespace bumpfoil
