#include "bumpfoil/experiments/reference_case.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

TEST(ReferenceCase, BumpsFillTheCircumference) {
  const Case reference = reference_case();
  // [Arghir2019, Table 1]: 26 pitches of 4.572 mm on a radius of 19.05 mm are 357.5 degrees.
  const double degrees = reference.bump_foil.bumps * reference.bump_foil.pitch.values.front() /
                         reference.bearing.radius * 180.0 / std::numbers::pi;
  EXPECT_NEAR(degrees, 357.5, 0.1);
}

TEST(ReferenceCase, IsPushedToTwoAndAHalfClearancesAlongBothAxes) {
  const Case reference = reference_case();
  // Both numbers have three digits.
  const auto& cycle = reference.settings.get<CycleSettings>();
  EXPECT_NEAR(cycle.amplitude.value / reference.bearing.radial_clearance, 2.5, 1e-12);
  ASSERT_EQ(cycle.directions.size(), 4U);
  EXPECT_EQ(unit_vector(cycle.directions[0]), Eigen::Vector2d(1.0, 0.0));
  EXPECT_EQ(unit_vector(cycle.directions[1]), Eigen::Vector2d(-1.0, 0.0));
  EXPECT_EQ(unit_vector(cycle.directions[2]), Eigen::Vector2d(0.0, 1.0));
  EXPECT_EQ(unit_vector(cycle.directions[3]), Eigen::Vector2d(0.0, -1.0));
}

TEST(ReferenceCase, IsFreeOfManufacturingErrors) {
  const Case reference = reference_case();
  EXPECT_TRUE(reference.bump_foil.height_errors.empty());
  EXPECT_TRUE(reference.bump_foil.sleeve_gaps.empty());
}

}  // namespace
}  // namespace bumpfoil
