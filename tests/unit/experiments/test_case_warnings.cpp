#include "bumpfoil/experiments/case_warnings.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/reference_case.hpp"

namespace bumpfoil {
namespace {

/// Warnings of the reference bearing with a top foil formed to `ratio` times the bearing radius.
std::vector<std::string> warnings_of_ratio(double ratio) {
  Case input = reference_case();
  input.top_foil.formed_radius = {FormedTo::radius, ratio * input.bearing.radius};
  return case_warnings(input);
}

bool has(const std::vector<std::string>& warnings, std::string_view text) {
  return warnings.size() == 1 && warnings.front().find(text) != std::string::npos;
}

TEST(CaseWarnings, SayWhatFormingDoes) {
  EXPECT_TRUE(case_warnings(reference_case()).empty());
  EXPECT_TRUE(warnings_of_ratio(1.01).empty());
  EXPECT_TRUE(has(warnings_of_ratio(0.998), "closes on the journal"));
  EXPECT_TRUE(has(warnings_of_ratio(1.02), "presses on a centred journal at rest"));  // clearance remains up to 1.0162
  EXPECT_EQ(warnings_of_ratio(1.5).size(), 2U);
  EXPECT_NE(warnings_of_ratio(1.5).front().find("trends"), std::string::npos);
}

TEST(CaseWarnings, SayWhatFoilsAreNotOverTheWidth) {
  Case input = reference_case();
  input.width.tilt = {1e-4, 0.0};
  EXPECT_TRUE(has(case_warnings(input), "resist the tilt"));
  input.width.tilt = {0.0, 0.0};
  input.width.conicity = 2e-6;
  EXPECT_TRUE(has(case_warnings(input), "resist the tilt"));
  input.width.modes = 3;
  EXPECT_TRUE(case_warnings(input).empty());
  input.bearing.axial_length *= 2.0;
  EXPECT_TRUE(has(case_warnings(input), "2 times as long"));
  input.width.sheet = true;
  EXPECT_TRUE(case_warnings(input).empty());
}

/// A steep truss with little support by its neighbours: the last foot wedges from 0.878 on (docs/theory/uniqueness.md).
TEST(CaseWarnings, SayWhereFrictionWedges) {
  Case input = reference_case();
  input.bump_foil.height = 1.7e-3;
  input.bump_foil.truss.k1 = 1e6;
  input.bump_foil.truss.k2 = input.bump_foil.truss.k3 = input.bump_foil.truss.k4 = 1e3;
  input.friction = {.top_bump = 0.87, .bump_sleeve = 0.87};
  EXPECT_TRUE(case_warnings(input).empty());
  input.friction.bump_sleeve = 0.88;
  EXPECT_TRUE(has(case_warnings(input), "wedges a foot of bump 26, which takes a coefficient of 0.878"));
}

TEST(CaseWarnings, NamePadsAndKeepRemarks) {
  Case input = reference_case();
  input.remarks = {"a remark"};
  input.bump_foil.bumps = 7;
  input.pads = {Pad{}, Pad{.top_foil = input.top_foil}, Pad{}};
  input.pads[1].top_foil->formed_radius = {FormedTo::radius, 19e-3};
  const std::vector<std::string> warnings = case_warnings(input);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0], "a remark");
  EXPECT_NE(warnings[1].find("of pad 2"), std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
