#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "support/bearing_cases.hpp"

/// Foils whose bumps differ, against the same foils said in another way, and against the frame.
namespace bumpfoil {
namespace {

constexpr double pi = std::numbers::pi;

Case short_cycles() {
  Case input = reference_case();
  input.cycle.steps = 20;
  return input;
}

/// Force, energies and loads of all increments of two cycles.
void expect_same(const Cycle& a, const Cycle& b, double part) {
  ASSERT_TRUE(a.converged() && b.converged());
  const double force = a.turning_point->max_force;
  for (std::size_t k = 0; k < a.increments.size(); ++k) {
    ASSERT_NEAR(a.increments[k].force_direct, b.increments[k].force_direct, part * force);
    ASSERT_NEAR(a.increments[k].force_cross, b.increments[k].force_cross, part * force);
  }
  ASSERT_TRUE(((a.turning_point->bump_loads - b.turning_point->bump_loads).cwiseAbs().array() <= part * force).all());
}

TEST(VariableFoils, AlikeBumpsAreTheUniformFoil) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = short_cycles();
    input.bump_foil.model = model;
    const Cycle uniform = run_single_cycle(input, pi);
    BumpFoil& foil = input.bump_foil;
    const auto all = [](double value) { return PerBump(std::vector<double>(26, value)); };
    foil.pitch = all(4.572e-3);
    foil.length = PerBump(3.556e-3, 3.556e-3, Grading::linear);
    foil.height = PerBump(0.508e-3, 0.508e-3, Grading::geometric);
    foil.thickness = 0.2e-3;
    foil.sections = {{.from = 1, .to = 10, .thickness = 0.102e-3}, {.from = 11, .to = 26, .thickness = 0.102e-3}};
    expect_same(uniform, run_single_cycle(input, pi), 0.0);
  }
}

TEST(VariableFoils, AShimIsAHeightErrorOfAllItsBumps) {
  for (const BumpFoilModel model : {BumpFoilModel::truss, BumpFoilModel::frame}) {
    Case input = short_cycles();
    input.bump_foil.model = model;
    Case with_errors = input;
    with_errors.bump_foil.height_errors.assign(26, 0.0);
    for (const std::size_t bump : {11U, 12U, 13U}) with_errors.bump_foil.height_errors[bump] = 25e-6;
    input.bump_foil.shims = {{.from = 12, .to = 14, .thickness = 25e-6}};
    expect_same(run_single_cycle(with_errors, 0.0), run_single_cycle(input, 0.0), 0.0);
    // It preloads: the journal is touched earlier than without.
    Case bare = input;
    bare.bump_foil.shims.clear();
    EXPECT_GT(run_single_cycle(input, 0.0).turning_point->max_force,
              1.01 * run_single_cycle(bare, 0.0).turning_point->max_force);
  }
}

TEST(VariableFoils, LowerBumpsAreFramesWhoseHeightErrorsShapeThem) {
  Case input = short_cycles();
  input.bump_foil.model = BumpFoilModel::frame;
  Case with_errors = input;
  with_errors.bump_foil.stiffness_follows_height = true;
  std::vector<double> heights(26, 0.508e-3);
  with_errors.bump_foil.height_errors.assign(26, 0.0);
  for (std::size_t n = 1; n < 26; n += 3) {
    heights[n] -= 8e-6;
    with_errors.bump_foil.height_errors[n] = -8e-6;
  }
  input.bump_foil.height = PerBump(heights);
  // Sums of heights and errors round to 1e-19 m; stiffnesses reach 1e8 N/m.
  expect_same(run_single_cycle(with_errors, 0.0), run_single_cycle(input, 0.0), 1e-9);
}

/// Force at full displacement of the truss over that of the frame, less one, along +X, +Y, -Y and -X.
std::array<double, 4> truss_over_frame(Case input) {
  std::array<double, 4> differences{};
  const std::array directions{0.0, 0.5 * pi, 1.5 * pi, pi};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    input.bump_foil.model = BumpFoilModel::truss;
    const double truss = run_single_cycle(input, directions[i]).turning_point->max_force;
    input.bump_foil.model = BumpFoilModel::frame;
    differences[i] = truss / run_single_cycle(input, directions[i]).turning_point->max_force - 1.0;
  }
  return differences;
}

/// Away from the weld.
double worst_inside(const std::array<double, 4>& differences) {
  return std::max({std::abs(differences[0]), std::abs(differences[1]), std::abs(differences[2])});
}

/// docs/variable_foils.md shows the table.
TEST(VariableFoils, TheTrussIsNoFurtherFromTheFrameThanOfUniformFoils) {
  const auto differences = [](PerBump BumpFoil::*dimension, const PerBump& value) {
    Case input = short_cycles();
    input.bump_foil.*dimension = value;
    return truss_over_frame(input);
  };
  struct Grade {
    PerBump BumpFoil::*dimension;
    double least;
    double most;
  };
  for (const auto& [dimension, least, most] : {Grade{&BumpFoil::pitch, 4.4e-3, 4.6e-3},
                                               {&BumpFoil::length, 3.4e-3, 3.8e-3},
                                               {&BumpFoil::height, 0.48e-3, 0.508e-3},
                                               {&BumpFoil::thickness, 0.09e-3, 0.12e-3}}) {
    const double uniform =
        std::max(worst_inside(differences(dimension, least)), worst_inside(differences(dimension, most)));
    for (const PerBump& graded : {PerBump(least, most, Grading::linear), PerBump(most, least, Grading::geometric)}) {
      const std::array<double, 4> found = differences(dimension, graded);
      SCOPED_TRACE(testing::Message() << graded.values.front() << " to " << graded.values.back());
      EXPECT_LT(worst_inside(found), 1.1 * uniform);
      // At the weld the first bump and the last one err either way, and in uniform foils against each other.
      EXPECT_LT(std::abs(found[3]), 0.1);
    }
  }
  // Every other bump of thicker sheet, and a group of other pitch: as far as the foil of the reference, and twice that.
  std::vector<double> every_other(26, 0.102e-3);
  for (std::size_t n = 0; n < 26; n += 2) every_other[n] = 0.127e-3;
  EXPECT_LT(worst_inside(differences(&BumpFoil::thickness, PerBump(every_other))), 0.02);
  std::vector<double> group(26, 4.73e-3);
  std::fill(group.begin() + 9, group.begin() + 16, 4.2e-3);
  EXPECT_LT(worst_inside(differences(&BumpFoil::pitch, PerBump(group))), 0.035);
}

}  // namespace
}  // namespace bumpfoil
