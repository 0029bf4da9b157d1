#include "bumpfoil/experiments/cycle/warnings.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/reference_case.hpp"

namespace bumpfoil {
namespace {

/// A result of one cycle without a reason for warnings.
CycleResult harmless() {
  Cycle cycle;
  cycle.amplitude = 50e-6;
  cycle.start.emplace();
  TurningPoint turn;
  turn.max_force = 10.0;
  turn.bump_loads = Vector::Ones(3);
  cycle.turning_point = turn;
  cycle.first_contact = 30e-6;
  return {.solver = SolverName::newton, .cycles = {cycle}};
}

/// The rise of whose bumps is 0.4 mm.
Case plain_case() {
  Case input = reference_case();
  input.bump_foil.height = 0.4e-3;
  input.bump_foil.height_reference = HeightReference::midsurface;
  return input;
}

TEST(Warnings, AreNotGivenWithoutNeed) {
  EXPECT_TRUE(warnings_of(plain_case(), harmless(), 0).empty());
}

TEST(Warnings, SayHowMuchLargeDisplacementsWouldSoften) {
  CycleResult result = harmless();
  Case input = plain_case();
  result.cycles[0].compression = CompressionPeak{.compression = 49e-6, .bump = 13, .increment = 7, .displacement = 0.0};
  EXPECT_TRUE(warnings_of(input, result, 0).empty());
  result.cycles[0].compression->compression = 60e-6;
  const std::vector<std::string> warnings = warnings_of(input, result, 0);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings[0],
      "bump 14 is compressed by 60 um, 0.15 of its rise (increment 7): large displacements, which are not modelled, "
      "would soften the foils by about 6 %; use bump_foil.model = \"frame\" with bump_foil.geometry = "
      "\"nonlinear\"");
  EXPECT_EQ(warning_lines(input, result), std::vector<std::string>{"+X: " + warnings[0]});
  input.bump_foil.geometry = Geometry::nonlinear;
  EXPECT_TRUE(warnings_of(input, result, 0).empty());
  result.cycles[0].compression->compression = 201e-6;
  ASSERT_EQ(warnings_of(input, result, 0).size(), 1U);
  EXPECT_NE(warnings_of(input, result, 0)[0].find("beyond half the rise"), std::string::npos);
}

TEST(Warnings, SayThatNothingWasTouched) {
  CycleResult result = harmless();
  result.cycles[0].turning_point->max_force = 0.0;
  result.cycles[0].turning_point->bump_loads.setZero();
  result.cycles[0].amplitude = 20e-6;
  const Case input = plain_case();
  ASSERT_EQ(warnings_of(input, result, 0).size(), 1U);
  EXPECT_EQ(warnings_of(input, result, 0)[0],
            "the journal, pushed to 20 um, never touches the foils, which start at 30 um: raise cycle.amplitude");
  result.cycles[0].first_contact.reset();
  EXPECT_EQ(warnings_of(input, result, 0)[0], "the journal never touches the foils: no bump faces this direction");
}

TEST(Warnings, SayThatALoopStillChanges) {
  CycleResult result = harmless();
  result.cycles[0].loop_energies = {5e-3, 4e-3};
  ASSERT_EQ(warnings_of(plain_case(), result, 0).size(), 1U);
  EXPECT_EQ(warnings_of(plain_case(), result, 0)[0],
            "the loop has not settled after 2 cycles: its energy, 4 mJ, is 20 % smaller than that of the "
            "previous loop; raise cycle.cycles");
  result.cycles[0].settled = true;
  EXPECT_TRUE(warnings_of(plain_case(), result, 0).empty());
}

TEST(Warnings, SayThatATrussIsNotMadeForAFewBumps) {
  Case input = plain_case();
  for (const int bumps : {1, 3, 4}) {
    input.bump_foil.bumps = bumps;
    EXPECT_EQ(warnings_of(input, harmless(), 0).size(), bumps < 4 ? 1U : 0U) << bumps;
  }
  input.bump_foil.bumps = 1;
  input.bump_foil.model = BumpFoilModel::frame;
  EXPECT_TRUE(warnings_of(input, harmless(), 0).empty());
}

TEST(Warnings, NameEveryFoilThatYields) {
  CycleResult result = harmless();
  result.cycles[0].top_foil_stress =
      StressPeak{.stress = 421e6, .place = StressPlace::crest, .bump = 4, .increment = 2, .displacement = 1e-6};
  Case input = plain_case();
  EXPECT_TRUE(warnings_of(input, result, 0).empty());
  input.top_foil.yield_stress = 421e6;
  EXPECT_TRUE(warnings_of(input, result, 0).empty());
  input.top_foil.yield_stress = 400e6;
  input.bump_foil.yield_stress = 1.0;  // the truss does not know its stress
  const std::vector<std::string> warnings = warnings_of(input, result, 0);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(
      warnings[0].starts_with("the top foil yields: its bending stress reaches 421 MPa (crest 5, increment 2), "
                              "its yield stress is 400 MPa"));
}

}  // namespace
}  // namespace bumpfoil
