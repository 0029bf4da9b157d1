// docs/verification/width.md: top foils split over the width, under a film: every strip is a bearing by itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"
#include "support/film_runs.hpp"

namespace bumpfoil {
namespace {

const double split_speed = speed_of_rpm(45000.0);
constexpr int strips = 3;
const Eigen::Vector2d some_slope(1e-4, -4e-5);

/// The reference bearing with its foils cut into strips, on a coarse mesh.
Case split_case(double friction, double gap = 0.0, int modes = 1) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4, .width_modes = modes}, friction);
  input.bump_foil.strips = strips;
  input.bump_foil.strip_gap = gap;
  input.top_foil.split = true;
  return input;
}

/// Strips that differ in every respect, on a foil with room for their stagger.
Case unlike_case(double friction, double gap) {
  Case input = split_case(friction, gap);
  input.bump_foil.truss = {};  // identified from the thickness
  input.bump_foil.bumps = 25;
  input.film.columns_per_pitch = 6;
  input.bump_foil.strip = {FoilStrip{.stagger = 1.0 / 6.0, .height_errors = PerBump(-2e-6, 1e-6, Grading::linear)},
                           FoilStrip{.stagger = 0.0, .height_errors = {}, .thickness = 0.12e-3},
                           FoilStrip{.stagger = 0.5, .height_errors = -2e-6}};
  return input;
}

/// One strip as a bearing, with its own width, stagger and heights.
Case alone_case(const Case& split, int strip) {
  Case input = split;
  const double gaps = (strips - 1) * split.bump_foil.strip_gap;
  input.bearing.axial_length = (split.bearing.axial_length - gaps) / strips;
  input.bump_foil.strips = 1;
  input.bump_foil.strip_gap = 0.0;
  input.top_foil.split = false;
  input.bump_foil.strip.clear();
  input.width.conicity = input.width.crowning = 0.0;
  if (split.bump_foil.strip.empty()) return input;
  const FoilStrip& own = split.bump_foil.strip[static_cast<std::size_t>(strip)];
  for (int n = 0; n < input.bump_foil.bumps; ++n) {
    input.bump_foil.height_errors.push_back(
        own.height_errors.at(static_cast<std::size_t>(n), static_cast<std::size_t>(input.bump_foil.bumps)));
  }
  if (own.thickness) input.bump_foil.thickness = *own.thickness;
  const double turned = own.stagger * split.bump_foil.pitch.values.front() / split.bearing.radius;
  input.bearing.weld_angle += split.bearing.wrap == Wrap::clockwise ? -turned : turned;
  return input;
}

/// z in the middle of a strip, m.
double middle_of(const Case& split, int strip) {
  const double gap = split.bump_foil.strip_gap;
  const double width = (split.bearing.axial_length - (strips - 1) * gap) / strips;
  return (strip - 1) * (width + gap);
}

/// Bearing with its journal held, after a path that makes contacts slide. @param beside  offset of all positions
struct Held {
  Held(const Case& input, const Eigen::Vector2d& position, const Eigen::Vector2d& beside = Eigen::Vector2d::Zero())
      : stepper(make_film_bearing(input)) {
    EXPECT_EQ(start_from_ambient(stepper, 0.5 * position + beside, split_speed, state).status, Status::converged);
    OperatingPoint point = OperatingPoint::held_at({}, split_speed);
    point.tilt = stepper.film().surroundings.tilt;
    for (const double part : {1.05, 1.0}) {
      point.journal = part * position + beside;
      EXPECT_EQ(follow(stepper, point, state).status, Status::converged);
    }
    outcome = film_bearing_outcome(stepper.bearing(), state);
  }
  FilmStepper stepper;
  BearingState state;
  FilmBearingOutcome outcome;
};

const Eigen::Vector2d some_position(24e-6, 7e-6);

/// Equal strips under an aligned journal are separate narrow bearings: the same equations on the same meshes.
TEST(FilmOnSplitFoils, OfEqualStripsIsThatOfNarrowBearings) {
  for (const double gap : {0.0, 2e-3}) {
    const Case input = split_case(0.1, gap);
    Held split(input, some_position);
    Held narrow(alone_case(input, 0), some_position);
    EXPECT_FALSE(split.stepper.film().tilts());
    ASSERT_EQ(split.stepper.film().pads.size(), 3U);
    const FilmBearingOutcome& one = narrow.outcome;
    ASSERT_GT(one.force.norm(), 5.0);
    EXPECT_LT((split.outcome.force - 3.0 * one.force).norm(), 1e-9 * split.outcome.force.norm());
    EXPECT_NEAR(split.outcome.power, 3.0 * one.power, 1e-9 * split.outcome.power);
    EXPECT_NEAR(split.outcome.flows.sides, 3.0 * one.flows.sides, 1e-9 * split.outcome.flows.sides);
    // The outer sides of the first and last strip are not slits.
    EXPECT_NEAR(split.outcome.slit_flow, 2.0 * one.flows.sides, 1e-9 * split.outcome.flows.sides);
    EXPECT_NEAR(split.outcome.thinnest.thickness, one.thinnest.thickness, 1e-9);
    EXPECT_EQ(split.outcome.loaded_bumps, 3 * one.loaded_bumps);
    const auto stiffness = split.stepper.slow_motion(split.state)->stiffness;
    EXPECT_LT((stiffness - 3.0 * narrow.stepper.slow_motion(narrow.state)->stiffness).norm(), 1e-9 * stiffness.norm());
    const std::complex<double> rate(0.0, 0.5 * split_speed);
    const auto whirl = split.stepper.impedance(split.state, {rate});
    const auto of_one = narrow.stepper.impedance(narrow.state, {rate});
    ASSERT_TRUE(whirl && of_one);
    EXPECT_LT((whirl->at(rate) - 3.0 * of_one->at(rate)).norm(), 1e-9 * whirl->at(rate).norm());
  }
}

/// Without friction, since sliding depends on the steps of the path. Each strip is computed as a bearing with its own
/// journal position and the same slope.
TEST(FilmOnSplitFoils, UnderATiltedJournalIsThatOfBearingsWhereItStands) {
  Case input = unlike_case(0.0, 1e-3);
  input.width.tilt = {some_slope.x(), some_slope.y()};
  const Held split(input, some_position);
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (int strip = 0; strip < strips; ++strip) {
    const double z = middle_of(input, strip);
    const FilmBearingOutcome one = Held(alone_case(input, strip), some_position, z * some_slope).outcome;
    EXPECT_LT((split.outcome.pad_forces.col(strip) - one.force).norm(), 1e-6 * one.force.norm()) << strip;
    force += one.force;
    moment += one.moment + z * one.force;
  }
  // Each to the tolerance of its solver.
  EXPECT_LT((split.outcome.force - force).norm(), 1e-7 * force.norm());
  EXPECT_LT((split.outcome.moment - moment).norm(), 1e-7 * moment.norm());
  EXPECT_GT(moment.norm(), 0.005);
}

/// The film of every strip satisfies its own equations, on the film thickness under the journal there.
TEST(FilmOnSplitFoils, SolvesItsEquations) {
  Case input = split_case(0.1, 1e-3, 3);
  input.width.tilt = {some_slope.x(), some_slope.y()};
  input.width.crowning = 3e-6;
  input.film.side_pressure = {1.02e5, 1.015e5};
  const Held held(input, some_position);
  const BearingModel& bearing = held.stepper.bearing();
  ASSERT_FALSE(HasFailure());
  expect_solved(bearing, held.state);
  const double c = bearing.film->scales.thickness;
  const double width = (input.bearing.axial_length - 2e-3) / strips;
  for (std::size_t k = 0; k < bearing.film->pads.size(); ++k) {
    const FilmPad& pad = bearing.film->pads[k];
    const FilmMesh& mesh = pad.foil.mesh;
    const Matrix H = part_of(pad, held.state.film.thickness);
    const Matrix lifts = part_of(pad, held.state.film.deflection);
    for (const int row : {0, 3, mesh.rows}) {
      const double across = 2.0 * row / mesh.rows - 1.0;
      const double z = middle_of(input, static_cast<int>(k)) + 0.5 * width * across;
      const double zeta = 2.0 * z / input.bearing.axial_length;
      const Vector lift = lifts.transpose() * pad.foil.lines.shapes(across);
      for (const int column : {0, 31, mesh.columns}) {
        const Eigen::Vector2d normal = bearing.film->column_normals.col(pad.first_column + column);
        const double h = bearing.clearance + 3e-6 * zeta * zeta - normal.dot(some_position + z * some_slope);
        EXPECT_NEAR(c * H(row, column), h + c * lift[column], 1e-15);
      }
    }
    // Gas is fed only at the sides of the bearing.
    const Matrix P = part_of(pad, held.state.film.pressure);
    EXPECT_DOUBLE_EQ(P(0, 5), k == 0 ? 1.02e5 / 101325.0 : 1.0);
    EXPECT_DOUBLE_EQ(P(mesh.rows, 5), k + 1 == bearing.film->pads.size() ? 1.015e5 / 101325.0 : 1.0);
  }
  const FilmFlows& flows = held.outcome.flows;
  EXPECT_NEAR(flows.start - flows.end, flows.sides, 1e-9 * std::abs(flows.start));
  EXPECT_GT(held.outcome.slit_flow, 0.0);
}

/// Exchanging the strips of both sides and reversing the tilt gives the mirror image.
TEST(FilmOnSplitFoils, IsMirroredWithThem) {
  Case input = unlike_case(0.1, 1e-3);
  input.width.tilt = {some_slope.x(), some_slope.y()};
  input.width.conicity = 2e-6;
  input.film.side_pressure = {1.02e5, 1.015e5};
  const Held here(input, some_position);
  std::reverse(input.bump_foil.strip.begin(), input.bump_foil.strip.end());
  std::reverse(input.film.side_pressure.begin(), input.film.side_pressure.end());
  input.width.tilt = {-some_slope.x(), -some_slope.y()};
  input.width.conicity = -2e-6;
  const Held image(input, some_position);
  // Searches end when steps are below 1e-9.
  EXPECT_LT((here.outcome.force - image.outcome.force).norm(), 1e-7 * here.outcome.force.norm());
  EXPECT_LT((here.outcome.moment + image.outcome.moment).norm(), 1e-7 * here.outcome.moment.norm());
  for (std::size_t k = 0; k < strips; ++k) {
    const BearingModel& one = here.stepper.bearing();
    const BearingModel& other = image.stepper.bearing();
    const Matrix pressure = part_of(one.film->pads[k], here.state.film.pressure);
    const Matrix mirrored = part_of(other.film->pads[strips - 1 - k], image.state.film.pressure).colwise().reverse();
    EXPECT_LT((pressure - mirrored).cwiseAbs().maxCoeff(), 1e-8);
  }
  const auto left_side = [](const FilmBearingOutcome& outcome) {
    return outcome.flows.sides - outcome.slit_flow - outcome.flows.right_side;
  };
  EXPECT_NEAR(left_side(here.outcome), image.outcome.flows.right_side, 1e-7 * std::abs(here.outcome.flows.sides));
}

/// Derivatives of forces and moments by displacements and tilts; strips resist a tilt even if each deflects uniformly.
TEST(FilmOnSplitFoils, HasTheStiffnessOfDifferences) {
  Case input = unlike_case(0.0, 1e-3);
  input.width.tilt = {some_slope.x(), some_slope.y()};
  Held held(input, some_position);
  OperatingPoint point = OperatingPoint::held_at(some_position, split_speed);
  point.tilt = held.stepper.film().surroundings.tilt;
  expect_stiffness_of_differences(held.stepper, point, held.state);
}

/// Pads with split foils: every strip of every pad.
TEST(FilmOnSplitFoils, OfPadsIsThatOfPadsSideBySide) {
  Case input = split_case(0.1, 1e-3);
  input.bump_foil.bumps = 8;
  input.pads.assign(3, {.lobe = 8e-6});
  input.pads[1].weld_edge = WeldEdge::trailing;
  const Held split(input, some_position);
  Case alone = alone_case(input, 0);
  const Held narrow(alone, some_position);
  ASSERT_EQ(split.outcome.pad_forces.cols(), 9);
  for (Eigen::Index pad = 0; pad < 9; ++pad) {
    EXPECT_LT((split.outcome.pad_forces.col(pad) - narrow.outcome.pad_forces.col(pad / 3)).norm(),
              1e-9 * split.outcome.force.norm());
  }
}

/// The mesh error of each strip is that of the narrow bearing.
TEST(FilmOnSplitFoils, HasTheMeshErrorOfNarrowBearings) {
  Case input = split_case(0.0);
  input.settings.set(EquilibriumSettings{.speeds = {split_speed}, .loads = {{90.0, 0.0}}, .paths = ComparedPaths::one});
  Case alone = alone_case(input, 0);
  alone.settings.get<EquilibriumSettings>().loads = {{30.0, 0.0}};
  EquilibriumResult split = run_equilibrium(input);
  EquilibriumResult narrow = run_equilibrium(alone);
  estimate_mesh_errors(input, split);
  estimate_mesh_errors(alone, narrow);
  const RunningState& found = split.states.front();
  const RunningState& reference = narrow.states.front();
  ASSERT_TRUE(found.mesh_error && reference.mesh_error);
  EXPECT_LT((found.last->position - reference.last->position).norm(), 1e-12);
  EXPECT_NEAR(found.mesh_error->minimum_film_thickness, reference.mesh_error->minimum_film_thickness, 1e-12);
  EXPECT_NEAR(found.mesh_error->force, 3.0 * reference.mesh_error->force, 1e-3 * found.mesh_error->force);
}

}  // namespace
}  // namespace bumpfoil
