#include "bumpfoil/experiments/properties/properties.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"

namespace bumpfoil {
namespace {

TEST(Properties, ReferenceTopFoilNearlyFloatsAtItsFreeEnd) {
  const std::optional<StiffnessRange> range = compute_properties(reference_case()).top_foil;
  ASSERT_TRUE(range.has_value());
  // Known to three digits.
  EXPECT_NEAR(range->softest, 4.88, 0.005);
  EXPECT_NEAR(range->stiffest, 6.43e5, 0.005e5);
}

TEST(Properties, SingleBumpStiffnessesAreInTheirOrder) {
  const Properties properties = compute_properties(reference_case());
  EXPECT_NEAR(properties.bumps.front().shallow_bump, 0.840e6, 0.0005e6);  // known to three digits
  // Foot friction stiffens loading and softens unloading; fixed feet are stiffest.
  EXPECT_LT(properties.bumps.front().unloading_bump.value(), properties.bumps.front().sliding_bump.value());
  EXPECT_LT(properties.bumps.front().sliding_bump.value(), properties.bumps.front().loading_bump.value());
  EXPECT_LT(properties.bumps.front().loading_bump.value(), properties.bumps.front().guided_bump);
}

TEST(Properties, RangeOfOneBumpIsThatOfItsMatrix) {
  Case input = reference_case();
  input.bump_foil.bumps = 1;
  // Rods of 2 MN/m at 45 degrees and springs of 1 MN/m give [Arghir2019, Eq. A1], reduced to one bump,
  // (3 0 -1 -1; 0 2 -1 -1; -1 -1 2 1; -1 -1 1 1) MN/m. Zeros of its characteristic polynomial by bisection:
  constexpr double softest = 0.1096314723;
  constexpr double stiffest = 4.5905642515;
  input.bump_foil.truss = {.k1 = 2e6, .k2 = 1e6, .k3 = 1e6, .k4 = 1e6, .theta_d = 0.25 * std::numbers::pi};
  const std::optional<StiffnessRange> range = compute_properties(input).bump_foil;
  ASSERT_TRUE(range.has_value());
  EXPECT_NEAR(range->softest, 1e6 * softest, 1e-3);  // digits given above
  EXPECT_NEAR(range->stiffest, 1e6 * stiffest, 1e-3);
}

TEST(Properties, AreThoseOfEachShapeOfBumps) {
  Case input = reference_case();
  input.bump_foil.sections = {{.from = 3, .to = 5, .thickness = 0.127e-3}};
  const std::vector<BumpProperties> bumps = compute_properties(input).bumps;
  ASSERT_EQ(bumps.size(), 3U);
  EXPECT_EQ(std::pair(bumps[0].from, bumps[0].to), std::pair(1, 2));
  EXPECT_EQ(std::pair(bumps[1].from, bumps[1].to), std::pair(3, 5));
  EXPECT_EQ(std::pair(bumps[2].from, bumps[2].to), std::pair(6, 26));
  EXPECT_EQ(bumps[2].identified.k1, bumps[0].identified.k1);
  Case thicker = reference_case();
  thicker.bump_foil.thickness = 0.127e-3;
  const std::vector<BumpProperties> uniform = compute_properties(thicker).bumps;
  ASSERT_EQ(uniform.size(), 1U);
  EXPECT_EQ(std::pair(uniform[0].from, uniform[0].to), std::pair(1, 26));
  EXPECT_EQ(bumps[1].identified.k1, uniform[0].identified.k1);
  EXPECT_EQ(bumps[1].sliding_bump, uniform[0].sliding_bump);
  EXPECT_GT(bumps[1].identified.k1, bumps[0].identified.k1);
  EXPECT_GT(bumps[0].identified.k1, 0.0);
}

TEST(Properties, AreThoseOfEachStripWithBumpsOfItsOwn) {
  Case input = reference_case();
  input.width.modes = 3;
  input.bump_foil.strips = 3;
  input.bump_foil.strip_gap = 2e-3;
  input.bump_foil.strip.resize(3);
  input.bump_foil.strip[0].height_errors = 1e-6;
  input.bump_foil.strip[1].thickness = 0.127e-3;
  const Properties properties = compute_properties(input);
  ASSERT_EQ(properties.strips.size(), 1U);
  const StripProperties& strip = properties.strips.front();
  EXPECT_EQ(strip.strip, 2);
  EXPECT_DOUBLE_EQ(strip.width, (input.bearing.axial_length - 4e-3) / 3.0);
  ASSERT_EQ(strip.bumps.size(), 1U);
  // A bearing as wide as the strip.
  Case narrow = reference_case();
  narrow.bearing.axial_length = strip.width;
  narrow.bump_foil.thickness = 0.127e-3;
  const Properties alone = compute_properties(narrow);
  EXPECT_DOUBLE_EQ(strip.bumps.front().identified.k1, alone.bumps.front().identified.k1);
  EXPECT_DOUBLE_EQ(strip.bumps.front().sliding_bump.value(), alone.bumps.front().sliding_bump.value());
  EXPECT_DOUBLE_EQ(strip.bump_foil->softest, alone.bump_foil->softest);
  EXPECT_NE(properties.bumps.front().shape, strip.bumps.front().shape);
}

TEST(Properties, LeavesOutWhatTakesTooLong) {
  Case input = reference_case();
  input.bump_foil.bumps = 3000;  // more unknowns than the limit for dense eigenvalues
  input.bearing.radius *= 3000.0 / 26.0;
  const Properties properties = compute_properties(input);
  EXPECT_FALSE(properties.top_foil.has_value());
  EXPECT_FALSE(properties.bump_foil.has_value());
}

TEST(Properties, RefusesWhatCannotBeBuilt) {
  Case input = reference_case();
  input.bump_foil.thickness = -1.0;
  EXPECT_THROW(static_cast<void>(compute_properties(input)), Error);
}

}  // namespace
}  // namespace bumpfoil
