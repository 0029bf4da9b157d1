#include "bumpfoil/model/geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;
/// Round-off of numbers of order one.
constexpr double rounding = 1e-14;

TEST(NominalBump, OverallHeightIncludesTheThickness) {
  Case input = reference_case();
  EXPECT_DOUBLE_EQ(nominal_bump(input.bump_foil).rise, 0.406e-3);
  input.bump_foil.height_reference = HeightReference::midsurface;
  EXPECT_DOUBLE_EQ(nominal_bump(input.bump_foil).rise, 0.508e-3);
}

TEST(CrestAngles, FirstCrestStandsHalfAPitchFromTheWeld) {
  const Case input = reference_case();
  const Vector theta = crest_angles(input);
  ASSERT_EQ(theta.size(), 26);
  EXPECT_NEAR(theta[0], 0.5 * 0.24, rounding);
  EXPECT_NEAR(theta[25], 25.5 * 0.24, rounding);  // p / R = 0.24
}

TEST(FootAngles, FeetStandBetweenTheCrestsOrAtTheEndsOfTheArcs) {
  Case input = reference_case();
  const Vector after = foot_angles(input);
  ASSERT_EQ(after.size(), 26);
  EXPECT_NEAR(after[0], 0.24, rounding);  // p / R = 0.24
  EXPECT_NEAR(after[25], 26 * 0.24, rounding);
  input.bump_foil.model = BumpFoilModel::frame;
  const Vector ends = foot_angles(input);
  ASSERT_EQ(ends.size(), 52);
  EXPECT_NEAR(ends[0], 0.508 / 19.05, rounding);  // half a flat from the weld
  EXPECT_NEAR(ends[1], (0.508 + 3.556) / 19.05, rounding);
  EXPECT_NEAR(ends[50] - ends[0], 25 * 0.24, rounding);
}

TEST(JournalGaps, DefaultsGiveTheTextbookForm) {
  // Weld at 180 deg, clockwise: r = C_r + x cos(theta) - y sin(theta).
  const Case input = reference_case();
  const Vector theta = crest_angles(input);
  const Eigen::Matrix2Xd normals = outward_normals(polar_angles(input.bearing, theta));
  const Eigen::Vector2d position(12e-6, -7e-6);
  const Vector r = journal_gaps(input.bearing.radial_clearance, normals, position);
  for (Eigen::Index i = 0; i < theta.size(); ++i) {
    EXPECT_NEAR(r[i], 31.8e-6 + 12e-6 * std::cos(theta[i]) + 7e-6 * std::sin(theta[i]), 1e-19);
  }
}

TEST(OutwardNormals, AreExactAlongTheAxes) {
  const Eigen::Matrix2Xd normals = outward_normals(Vector{{0.0, 0.5 * std::numbers::pi, std::numbers::pi, 0.7}});
  EXPECT_EQ(normals.col(0), Eigen::Vector2d(1.0, 0.0));
  EXPECT_EQ(normals.col(1), Eigen::Vector2d(0.0, 1.0));
  EXPECT_EQ(normals.col(2), Eigen::Vector2d(-1.0, 0.0));
  EXPECT_EQ(normals.col(3), Eigen::Vector2d(std::cos(0.7), std::sin(0.7)));
}

TEST(JournalForce, PushingTowardsABumpNeedsAForceTowardsIt) {
  const Case input = reference_case();
  const Vector phi = polar_angles(input.bearing, crest_angles(input));
  Vector loads = Vector::Zero(phi.size());
  loads[4] = 3.0;
  const Eigen::Vector2d force = journal_force(outward_normals(phi), loads);
  EXPECT_NEAR(force.norm(), 3.0, rounding);
  EXPECT_NEAR(std::atan2(force.y(), force.x()), phi[4], rounding);
  // Bump 5 is in the half plane of +Y with the default weld and wrap.
  EXPECT_GT(force.y(), 0.0);
}

TEST(UnitVector, IsExactAlongTheAxes) {
  EXPECT_EQ(unit_vector(0.0), Eigen::Vector2d(1, 0));
  EXPECT_EQ(unit_vector(pi / 2), Eigen::Vector2d(0, 1));
  EXPECT_EQ(unit_vector(pi), Eigen::Vector2d(-1, 0));
  EXPECT_EQ(unit_vector(1.5 * pi), Eigen::Vector2d(0, -1));
  EXPECT_EQ(unit_vector(-pi / 2), Eigen::Vector2d(0, -1));
  EXPECT_EQ(unit_vector(4.0 * pi), Eigen::Vector2d(1, 0));
  EXPECT_DOUBLE_EQ(unit_vector(pi / 6).x(), std::cos(pi / 6));
}

TEST(BearingFoils, HaveTheNominalBumpEverywhere) {
  Case input = reference_case();
  input.bump_foil.height_errors = std::vector<double>(26, 5e-6);  // affects gaps only
  const FoilDesign foils = make_bearing_design(input);
  EXPECT_EQ(foils.bumps, std::vector<BumpShape>(26, nominal_bump(input.bump_foil)));
  EXPECT_EQ(foils.radius, input.bearing.radius);
  EXPECT_TRUE(foils.welded);
  EXPECT_TRUE(foils.top_foil);
  input.bump_foil.model = BumpFoilModel::former;
  EXPECT_FALSE(make_bearing_design(input).top_foil);
}

TEST(BearingFoils, FollowTheHeightErrorsWhereStiffnessDoes) {
  Case input = reference_case();
  input.bump_foil.bumps = 3;
  input.bump_foil.stiffness_follows_height = true;
  EXPECT_DOUBLE_EQ(make_bearing_design(input).bumps[2].rise, 0.406e-3);
  input.bump_foil.height_errors = {0.0, 20e-6, -15e-6};
  const FoilDesign foils = make_bearing_design(input);
  ASSERT_EQ(foils.bumps.size(), 3U);
  EXPECT_DOUBLE_EQ(foils.bumps[0].rise, 0.406e-3);
  EXPECT_DOUBLE_EQ(foils.bumps[1].rise, 0.426e-3);
  EXPECT_DOUBLE_EQ(foils.bumps[2].rise, 0.391e-3);
  EXPECT_EQ(foils.bumps[1].half_length, foils.bumps[0].half_length);
}

TEST(BearingFoils, HaveTheBumpsOfTheirSections) {
  Case input = reference_case();
  input.bump_foil.bumps = 5;
  input.bump_foil.pitch = PerBump(std::vector{4e-3, 4.1e-3, 4.2e-3, 4.3e-3, 4.4e-3});
  input.bump_foil.thickness = PerBump(0.1e-3, 0.14e-3, Grading::linear);
  input.bump_foil.sections = {{.from = 2, .to = 3, .height = 0.6e-3}, {.from = 5, .to = 5, .thickness = 0.2e-3}};
  const FoilDesign foils = make_bearing_design(input);
  const double half_length = 0.5 * 3.556e-3;
  const std::vector<BumpShape> expected{{4e-3, half_length, 0.508e-3 - 0.1e-3, 0.1e-3},
                                        {4.1e-3, half_length, 0.6e-3 - 0.11e-3, 0.11e-3},
                                        {4.2e-3, half_length, 0.6e-3 - 0.12e-3, 0.12e-3},
                                        {4.3e-3, half_length, 0.508e-3 - 0.13e-3, 0.13e-3},
                                        {4.4e-3, half_length, 0.508e-3 - 0.2e-3, 0.2e-3}};
  for (std::size_t n = 0; n < expected.size(); ++n) {
    EXPECT_DOUBLE_EQ(foils.bumps[n].pitch, expected[n].pitch) << n;
    EXPECT_DOUBLE_EQ(foils.bumps[n].half_length, expected[n].half_length) << n;
    EXPECT_DOUBLE_EQ(foils.bumps[n].rise, expected[n].rise) << n;
    EXPECT_DOUBLE_EQ(foils.bumps[n].thickness, expected[n].thickness) << n;
  }
}

TEST(RadiusProfile, AddsItsWavesAndWhatWasMeasured) {
  using std::numbers::pi;
  EXPECT_EQ(deviation_at({}, 1.0), 0.0);
  const RadiusProfile waves{.waves = {{3, 5e-6, 0.7}, {1, 2e-6, 0.0}}};
  EXPECT_NEAR(deviation_at(waves, 1.1), 5e-6 * std::cos(3.0 * 1.1 - 0.7) + 2e-6 * std::cos(1.1), 1e-20);
  // At X, Y, -X and -Y, linear in between, and periodic.
  const RadiusProfile measured{.deviations = {1e-6, 3e-6, 0.0, -2e-6}};
  for (const double turn : {-2.0 * pi, 0.0, 4.0 * pi}) {
    EXPECT_NEAR(deviation_at(measured, turn), 1e-6, 1e-20);
    EXPECT_NEAR(deviation_at(measured, turn + 0.5 * pi), 3e-6, 1e-20);
    EXPECT_NEAR(deviation_at(measured, turn + 0.25 * pi), 2e-6, 1e-20);
    EXPECT_NEAR(deviation_at(measured, turn - 0.125 * pi), 0.25e-6, 1e-20);
  }
  EXPECT_NEAR(deviation_at(measured, -1e-18), 1e-6, 1e-20);
  const RadiusProfile both{.waves = waves.waves, .deviations = measured.deviations};
  EXPECT_NEAR(deviation_at(both, 2.0), deviation_at(waves, 2.0) + deviation_at(measured, 2.0), 1e-20);
}

TEST(CrestOffsets, CountFromTheTallestNominalBump) {
  BumpFoil foil = reference_case().bump_foil;
  foil.bumps = 4;
  EXPECT_TRUE(crest_offsets(foil).isZero(0.0));
  foil.height = PerBump(std::vector{0.5e-3, 0.52e-3, 0.51e-3, 0.52e-3});
  foil.height_errors = {1e-6, 2e-6, 0.0, 0.0};
  foil.shims = {{.from = 3, .to = 4, .thickness = 15e-6}};
  // Millionths of a micrometre are round-off of the heights.
  EXPECT_TRUE(crest_offsets(foil).isApprox(Vector{{-19e-6, 2e-6, 5e-6, 15e-6}}, 1e-9)) << crest_offsets(foil);
  // With mid-surface heights, thicker foils are taller.
  foil.height_errors.clear();
  foil.shims.clear();
  foil.height = 0.4e-3;
  foil.height_reference = HeightReference::midsurface;
  foil.thickness = PerBump(std::vector{0.1e-3, 0.1e-3, 0.1e-3, 0.12e-3});
  EXPECT_TRUE(crest_offsets(foil).isApprox(Vector{{-20e-6, -20e-6, -20e-6, 0.0}}, 1e-9)) << crest_offsets(foil);
}

TEST(StripFoils, AreFlatAndCutToTheStrip) {
  const Case input = reference_case();
  const FoilDesign bare = make_strip_design(input, 4, StripWeld::none, false);
  EXPECT_EQ(bare.bumps.size(), 4U);
  EXPECT_FALSE(bare.radius);
  EXPECT_FALSE(bare.welded);
  EXPECT_FALSE(bare.top_foil);
  const FoilDesign whole = make_strip_design(input, 4, StripWeld::one_end, true);
  EXPECT_TRUE(whole.welded);
  EXPECT_TRUE(whole.top_foil);
}

TEST(CutTo, KeepsTheFirstBumps) {
  Case input = reference_case();
  input.bump_foil.height_errors.assign(26, 1e-6);
  input.bump_foil.height_errors[2] = 3e-6;
  const PadDesign cut = cut_to(input, 3);
  EXPECT_EQ(cut.bump_foil.bumps, 3);
  EXPECT_EQ(cut.bump_foil.height_errors, (std::vector<double>{1e-6, 1e-6, 3e-6}));
  EXPECT_TRUE(cut.bump_foil.sleeve_gaps.empty());
}

TEST(CutTo, LeavesGradedBumpsAsTheyAre) {
  Case input = reference_case();
  input.bump_foil.pitch = PerBump(4.2e-3, 4.8e-3, Grading::linear);
  input.bump_foil.height = PerBump(0.5e-3, 0.4e-3, Grading::geometric);
  input.bump_foil.sections = {{.from = 3, .to = 9, .thickness = 0.12e-3}};
  const std::vector<BumpShape> cut = nominal_bumps(cut_to(input, 3).bump_foil);
  ASSERT_EQ(cut.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(cut[n], nominal_bump(input.bump_foil, n)) << n;
}

}  // namespace
}  // namespace bumpfoil
