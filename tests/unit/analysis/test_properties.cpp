#include "bumpfoil/analysis/properties.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

/// Known numbers of the reference bearing have three or four digits.
constexpr double digits = 0.005;

Properties reference(HeightReference reading, double friction = 0.1) {
  Case input = reference_case();
  input.bump_foil.height_reference = reading;
  input.friction.bump_sleeve = friction;
  return compute_properties(input);
}

void expect_near(double value, double expected) {
  EXPECT_NEAR(value, expected, digits * expected);
}

TEST(Properties, AreThoseOfTheReferenceBearing) {
  // From a prototype in another language.
  const Properties tall = reference(HeightReference::midsurface);
  expect_near(tall.cell.crest_stiffness(), 1.972e6);
  expect_near(tall.identified.k1, 111.7e6);
  expect_near(tall.identified.k4, 6.67e6);
  expect_near(tall.shallow_bump, 0.840e6);
  expect_near(*tall.sliding_bump, 0.828e6);
  expect_near(tall.guided_bump, 3.156e6);
  expect_near(tall.top_foil->softest, 4.88);
  expect_near(tall.top_foil->stiffest, 6.43e5);
  expect_near(reference(HeightReference::overall).cell.crest_stiffness(), 1.988e6);
}

TEST(Properties, FrictionOpposesLoadingAndUnloading) {
  const Properties rough = reference(HeightReference::overall, 0.1);
  EXPECT_GT(*rough.loading_bump, *rough.sliding_bump);
  EXPECT_LT(*rough.unloading_bump, *rough.sliding_bump);
  const Properties smooth = reference(HeightReference::overall, 0.0);
  EXPECT_EQ(smooth.loading_bump, smooth.sliding_bump);
  EXPECT_EQ(smooth.unloading_bump, smooth.sliding_bump);
}

TEST(Properties, ModesOfTheFoilsArePositive) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = reference_case();
    input.bump_foil.model = model;
    const Properties properties = compute_properties(input);
    ASSERT_TRUE(properties.bump_foil);
    EXPECT_GT(properties.bump_foil->softest, 0.0);
    EXPECT_GT(properties.bump_foil->stiffest, properties.bump_foil->softest);
  }
}

TEST(Properties, ScaleWithTheModulus) {
  Case input = reference_case();
  const Properties once = compute_properties(input);
  input.bump_foil.youngs_modulus *= 4.0;
  input.top_foil.youngs_modulus *= 4.0;
  const Properties four = compute_properties(input);
  // Roundings of condensed matrices of condition 1e9.
  EXPECT_NEAR(four.identified.k2 / once.identified.k2, 4.0, 1e-6);
  EXPECT_NEAR(four.top_foil->softest / once.top_foil->softest, 4.0, 1e-6);
  EXPECT_NEAR(four.bump_foil->stiffest / once.bump_foil->stiffest, 4.0, 1e-6);
}

TEST(Properties, LeaveOutTheModesOfEndlessFoils) {
  Case input = reference_case();
  input.bump_foil.bumps = 2600;
  input.bearing.radius *= 100.0;
  const Properties properties = compute_properties(input);
  EXPECT_FALSE(properties.top_foil);
  EXPECT_FALSE(properties.bump_foil);
}

TEST(Properties, WantAValidCase) {
  Case input = reference_case();
  input.bump_foil.pitch = -1.0;
  EXPECT_THROW((void)compute_properties(input), Error);
}

}  // namespace
}  // namespace bumpfoil
