#include "bumpfoil/model/pads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;

Case of_pads(std::size_t pads) {
  Case input = reference_case();
  input.bump_foil.bumps = 7;
  input.pads.resize(pads);
  return input;
}

/// Checks that two angles are the same except for whole turns.
void expect_angle(double angle, double expected) {
  EXPECT_NEAR(std::remainder(angle - expected, 2.0 * pi), 0.0, 1e-14);
}

TEST(Pads, WithoutAnyTheBearingIsOne) {
  const Case input = reference_case();
  const std::vector<PlacedPad> pads = place_pads(input);
  ASSERT_EQ(pads.size(), 1U);
  EXPECT_EQ(pads[0].alone, static_cast<const PadDesign&>(input));
  EXPECT_EQ(pads[0].centre, Eigen::Vector2d::Zero());
  EXPECT_EQ(count_pads(input), 1U);
  EXPECT_EQ(total_bumps(input), 26);
}

TEST(Pads, BeginAtEqualAnglesAndAreAsLongAsTheirBumps) {
  for (const auto& [wrap, sense] : {std::pair{Wrap::clockwise, -1.0}, std::pair{Wrap::counterclockwise, 1.0}}) {
    Case input = of_pads(3);
    input.bearing.wrap = wrap;
    input.bearing.weld_angle = 0.3;
    input.pads[1].weld_edge = WeldEdge::trailing;
    const std::vector<PlacedPad> pads = place_pads(input);
    const double arc = 7 * 4.572e-3 / 19.05e-3;
    EXPECT_EQ(pads[0].alone.bearing.weld_angle, 0.3);
    EXPECT_EQ(pads[0].alone.bearing.wrap, wrap);
    expect_angle(pads[1].alone.bearing.weld_angle, 0.3 + sense * (2.0 * pi / 3.0 + arc));
    EXPECT_NE(pads[1].alone.bearing.wrap, wrap);
    expect_angle(pads[2].alone.bearing.weld_angle, 0.3 + sense * 4.0 * pi / 3.0);
    for (const PlacedPad& pad : pads) {
      EXPECT_DOUBLE_EQ(foil_angle(pad.alone), arc);
      EXPECT_DOUBLE_EQ(pad.arc, arc);
      EXPECT_EQ(pad.sense(), pad.alone.bearing.wrap == wrap ? sense : -sense);
      expect_angle(pad.end(), pad.alone.bearing.weld_angle + pad.sense() * arc);
      EXPECT_DOUBLE_EQ(pad.crests[2], 2.5 * arc / 7.0);
      EXPECT_EQ(pad.feet, foot_angles(pad.alone));
      expect_angle(pad.polar(pad.crests)[2], pad.alone.bearing.weld_angle + pad.sense() * 2.5 * arc / 7.0);
    }
  }
}

TEST(Pads, StretchTheirPitchesToTheirArc) {
  Case input = of_pads(4);
  input.bump_foil.sections = {{.from = 2, .to = 3, .pitch = 4e-3}};
  input.bearing.pad_gap = 0.1;
  input.pads[1].arc = 1.2;
  const std::vector<PlacedPad> pads = place_pads(input);
  EXPECT_NEAR(foil_angle(pads[0].alone), 0.5 * pi - 0.1, 1e-14);
  EXPECT_NEAR(foil_angle(pads[1].alone), 1.2, 1e-14);
  EXPECT_NEAR(pads[1].arc, 1.2, 1e-14);
  EXPECT_EQ(pads[1].crests, crest_angles(pads[1].alone));
  // All scaled alike: their ratio is unchanged.
  const std::vector<BumpShape> bumps = nominal_bumps(pads[1].alone.bump_foil);
  EXPECT_DOUBLE_EQ(bumps[1].pitch / bumps[0].pitch, 4.0 / 4.572);
}

TEST(Pads, HaveFoilsAndWeldsOfTheirOwn) {
  Case input = of_pads(2);
  input.pads[1].weld_angle = -1.0;
  input.pads[1].bump_foil = input.bump_foil;
  input.pads[1].bump_foil->bumps = 5;
  input.pads[1].top_foil = input.top_foil;
  input.pads[1].top_foil->thickness = 0.2e-3;
  const std::vector<PlacedPad> pads = place_pads(input);
  EXPECT_EQ(pads[0].alone.bump_foil, input.bump_foil);
  EXPECT_EQ(pads[0].alone.top_foil, input.top_foil);
  EXPECT_EQ(pads[1].alone.bump_foil.bumps, 5);
  EXPECT_EQ(pads[1].alone.top_foil.thickness, 0.2e-3);
  EXPECT_EQ(pads[1].alone.bearing.weld_angle, -1.0);
  EXPECT_EQ(total_bumps(input), 12);
  const PadBump last = find_bump(input, 11);
  EXPECT_EQ(last.pad, 1U);
  EXPECT_EQ(last.bump, 4);
  EXPECT_EQ(find_bump(input, 6).pad, 0U);
  EXPECT_EQ(find_bump(input, 7).bump, 0);
}

/// Starting at the side z < 0, with the weld position of the strip.
TEST(Pads, AreCutIntoTheirStripsUnderAFilm) {
  Case input = of_pads(2);
  EXPECT_EQ(place_film_pads(input).size(), 2U);
  input.bump_foil.strips = 3;
  input.bump_foil.strip_gap = 2e-3;
  input.bump_foil.strip = {FoilStrip{}, FoilStrip{.stagger = 0.5, .height_errors = -1e-6}, FoilStrip{}};
  EXPECT_EQ(place_film_pads(input).size(), 2U);
  input.top_foil.split = true;
  const std::vector<PlacedPad> whole = place_pads(input);
  const std::vector<PlacedPad> strips = place_film_pads(input);
  ASSERT_EQ(strips.size(), 6U);
  const double width = (input.bearing.axial_length - 4e-3) / 3.0;
  for (std::size_t k = 0; k < strips.size(); ++k) {
    const PlacedPad& one = strips[k];
    const auto strip = static_cast<int>(k % 3);
    EXPECT_EQ(one.strip, strip);
    EXPECT_NEAR(one.alone.bearing.axial_length, width, 1e-15);
    EXPECT_EQ(make_bearing_design(one.alone).bump_foil_width(), one.alone.bearing.axial_length);
    EXPECT_NEAR(0.5 * one.middle * input.bearing.axial_length, (strip - 1) * (width + 2e-3), 1e-15);
    EXPECT_NEAR(one.part * input.bearing.axial_length, width, 1e-15);
    const double further = strip == 1 ? 0.5 * 4.572e-3 / input.bearing.radius : 0.0;
    EXPECT_NEAR(one.alone.bearing.weld_angle - whole[k / 3].alone.bearing.weld_angle, one.sense() * further, 1e-12);
    EXPECT_NEAR(crest_offsets(one.alone.bump_foil)[0], strip == 1 ? -1e-6 : 0.0, 1e-18);
  }
  EXPECT_EQ(film_bumps(input), 3 * total_bumps(input));
}

TEST(Pads, LieOnCirclesDisplacedAwayFromTheirMiddle) {
  Case input = of_pads(1);
  input.pads[0].lobe = 10e-6;
  input.pads[0].arc = 2.0;
  input.bearing.weld_angle = 1.0;  // clockwise from there: the middle is at X
  const PlacedPad pad = place_pads(input).front();
  EXPECT_EQ(pad.lobe, 10e-6);
  EXPECT_NEAR(pad.centre.x(), -10e-6, 1e-18);
  EXPECT_NEAR(pad.centre.y(), 0.0, 1e-18);
}

}  // namespace
}  // namespace bumpfoil
