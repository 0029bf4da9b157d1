#include "bumpfoil/model/foil_design.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bumpfoil {
namespace {

/// Round-off of numbers of order one.
constexpr double design_round_off = 1e-14;
constexpr BumpShape reference_shape{
    .pitch = 4.572e-3, .half_length = 1.778e-3, .rise = 0.406e-3, .thickness = 0.102e-3};

FoilDesign row_of(std::vector<BumpShape> bumps) {
  FoilDesign foils;
  foils.bumps = std::move(bumps);
  return foils;
}

/// Bumps with increasing pitches and chords.
FoilDesign graded() {
  FoilDesign foils = row_of({reference_shape, reference_shape, reference_shape});
  foils.bumps[1].pitch = 5e-3;
  foils.bumps[1].half_length = 2e-3;
  foils.bumps[2].pitch = 6e-3;
  foils.bumps[2].half_length = 2.5e-3;
  return foils;
}

TEST(BumpArc, MeetsItsDefinition) {
  for (const double rise : {0.1e-3, 0.406e-3, 3e-3}) {  // the last is more than a half circle
    BumpShape bump = reference_shape;
    bump.rise = rise;
    const BumpArc arc = make_bump_arc(bump);
    EXPECT_NEAR(std::sin(arc.half_angle), arc.half_length / arc.radius, design_round_off);
    EXPECT_NEAR(arc.radius * (1.0 - std::cos(arc.half_angle)), arc.rise, design_round_off);
    EXPECT_EQ(arc.half_angle > std::numbers::pi / 2, arc.rise > arc.half_length);
    EXPECT_NEAR(arc.flat, 1.016e-3, design_round_off);
  }
}

TEST(CrestPositions, OfEqualPitchesAreMultiplesToTheLastDigit) {
  const Vector crests = crest_positions(row_of(std::vector<BumpShape>(100'000, reference_shape)));
  ASSERT_EQ(crests.size(), 100'000);
  for (const Eigen::Index i : {0, 1, 25, 99'999}) {
    EXPECT_EQ(crests[i], reference_shape.pitch * (static_cast<double>(i) + 0.5));
  }
}

TEST(CrestPositions, StandInTheMiddleOfPitchesThatAddUp) {
  const Vector crests = crest_positions(graded());
  EXPECT_LT((crests - Vector{{2.286e-3, 4.572e-3 + 2.5e-3, 9.572e-3 + 3e-3}}).norm(), 1e-17);
  // Groups of equal pitches within a foil.
  FoilDesign groups = row_of({reference_shape, reference_shape, reference_shape, reference_shape, reference_shape});
  groups.bumps[2].pitch = groups.bumps[3].pitch = 1e-3;
  const double p = reference_shape.pitch;
  const Vector expected{{0.5 * p, 1.5 * p, 2.0 * p + 0.5e-3, 2.0 * p + 1.5e-3, 2.5 * p + 2e-3}};
  EXPECT_LT((crest_positions(groups) - expected).norm(), 1e-17);
}

TEST(FootPositions, StandBetweenTheCrestsOrAtTheEndsOfTheArcs) {
  FoilDesign foils = graded();
  EXPECT_LT((foot_positions(foils) - Vector{{4.572e-3, 9.572e-3, 15.572e-3}}).norm(), 1e-17);
  foils.welded = false;
  EXPECT_LT((foot_positions(foils) - Vector{{0.0, 4.572e-3, 9.572e-3, 15.572e-3}}).norm(), 1e-17);
  foils.model = BumpFoilModel::frame;
  const Vector ends{{0.508e-3, 4.064e-3, 5.072e-3, 9.072e-3, 10.072e-3, 15.072e-3}};
  EXPECT_LT((foot_positions(foils) - ends).norm(), 1e-17);
  foils.welded = true;
  EXPECT_LT((foot_positions(foils) - ends).norm(), 1e-17);
}

TEST(FoilDesign, ScalesByThePitchOfTheFirstBump) {
  EXPECT_EQ(graded().reference_length(), reference_shape.pitch);
}

}  // namespace
}  // namespace bumpfoil
