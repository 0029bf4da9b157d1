// docs/verification/width.md: bump foils split into strips, under a film.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bumpfoil/bearing/fields.hpp"
#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"
#include "bumpfoil/motion/load_search.hpp"
#include "support/film_runs.hpp"

namespace bumpfoil {
namespace {

const Eigen::Vector2d some_load(80.0, 0.0);

/// The reference bearing with its bump foil in three strips, on a coarse mesh.
Case split_case(int modes, double friction) {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 4, .width_modes = modes}, friction);
  input.bump_foil.strips = 3;
  input.settings.set(
      EquilibriumSettings{.speeds = {speed_of_rpm(45000.0)}, .loads = {some_load}, .paths = ComparedPaths::one});
  return input;
}

/// Strips with bumps of different heights.
Case differing_case(double friction) {
  Case input = split_case(3, friction);
  input.bump_foil.strip = {FoilStrip{.stagger = 0.0, .height_errors = PerBump(-4e-6, 3e-6, Grading::linear)},
                           FoilStrip{}, FoilStrip{.stagger = 0.0, .height_errors = -5e-6}};
  return input;
}

/// Strips that are also staggered, one by one column of the mesh, on a foil with room for that, and one thicker.
Case staggered_case(double friction) {
  Case input = differing_case(friction);
  input.bump_foil.truss = {};  // identified from the thickness
  input.bump_foil.strip[1].thickness = 0.12e-3;
  input.film.columns_per_pitch = 6;
  input.bump_foil.bumps = 25;
  input.bump_foil.strip[0].stagger = 1.0 / 6.0;
  input.bump_foil.strip[2].stagger = 0.5;
  return input;
}

RunningState state_of(const Case& input, SharedBearing& bearing) {
  const EquilibriumResult result = run_equilibrium(input);
  bearing = result.bearing;
  EXPECT_TRUE(result.states.front().found());
  return result.states.front();
}

/// Slices under the points of strips move like those of a whole bump foil that moves linearly over the width: the same
/// bearing with other unknowns.
TEST(FilmOnStrips, ThatAreAlikeIsThatOnOneOfTheirWidth) {
  Case split = split_case(2, 0.0);
  split.width.tilt = {4e-6 / split.bearing.axial_length, 2e-6 / split.bearing.axial_length};
  Case whole = split;
  whole.bump_foil.strips = 1;
  SharedBearing on_strips, on_one;
  const RunningState found = state_of(split, on_strips);
  const RunningState reference = state_of(whole, on_one);
  expect_solved(*on_strips, *found.last);
  EXPECT_EQ(on_strips->points.size(), 6U);
  // Each to the tolerance of its solver.
  EXPECT_LT((found.last->position - reference.last->position).norm(), 1e-7 * on_one->clearance);
  EXPECT_LT((found.outcome->moment - reference.outcome->moment).norm(), 1e-6 * reference.outcome->moment.norm());
  EXPECT_LT((bump_loads(*on_strips, *found.last) - bump_loads(*on_one, *reference.last)).norm(),
            1e-6 * some_load.norm());
  EXPECT_LT((*found.stiffness - *reference.stiffness).norm(), 1e-5 * reference.stiffness->norm());
}

/// The same with friction along the same path: aligned, since under a tilt points slide one by one.
TEST(FilmOnStrips, ThatAreAlikeRubsAsOnOneOfTheirWidth) {
  Case split = split_case(2, 0.1);
  split.width.moment = {0.0, 0.0};  // the whole width
  Case whole = split;
  whole.bump_foil.strips = 1;
  FilmBearingOutcome outcome[2];
  for (const int which : {0, 1}) {
    const BearingModel bearing = make_film_bearing(which == 0 ? split : whole);
    FilmStepper stepper(bearing);
    BearingState state;
    const double speed = speed_of_rpm(45000.0);
    ASSERT_EQ(start_from_ambient(stepper, {0.6 * bearing.clearance, 0.2 * bearing.clearance}, speed, state).status,
              Status::converged);
    OperatingPoint point = point_of(bearing, state, {});
    for (const double move : {2e-6, 4e-6, -1e-6}) {
      point.journal.x() += move;
      ASSERT_EQ(stepper.advance(point, state).status, Status::converged);
    }
    expect_solved(bearing, state);
    outcome[which] = film_bearing_outcome(bearing, state);
  }
  EXPECT_LT((outcome[0].force - outcome[1].force).norm(), 1e-6 * outcome[1].force.norm());
  EXPECT_LT(outcome[0].moment.norm(), 1e-9 * outcome[1].force.norm());
}

/// At rest stiff asperities hold the journal as in the dry bearing: another solver on another matrix, with contact on
/// three lines over the width instead of at all rows.
void expect_held_at_rest_as_without_a_film(Case input) {
  input.asperity = AsperitySettings{.sigma = 0.01e-6, .pressure_factor = 240e6, .friction = 0.2};
  input.settings.get<EquilibriumSettings>().speeds = {0.0};
  SharedBearing bearing;
  const RunningState running = state_of(input, bearing);

  FoilStepper dry = make_stepper(make_bearing_foils(input));
  Step step;
  advance_to_load(dry, BearingState::unstressed(dry.foils()), some_load, 1e-6, 3.0 * input.bearing.radial_clearance,
                  step);
  ASSERT_TRUE(step.converged());
  // Asperities keep the surfaces 0.03 um apart.
  EXPECT_LT((running.last->position - step.state.position).norm(), 0.06e-6);
  const Vector strips = strip_loads(*bearing, running.last->contacts);
  const Vector dry_strips = strip_loads(dry.foils(), step.state.contacts);
  ASSERT_EQ(strips.size(), 3);
  EXPECT_LT((strips - dry_strips).cwiseAbs().maxCoeff(), 5e-3 * some_load.norm());
  EXPECT_GT(strips[1], 1.2 * strips[2]);  // the lowest carries least
  const double moment = holding_moment(dry.foils(), step.state.contacts.normal_force).x();
  EXPECT_NEAR(running.outcome->moment.x(), moment, 5e-3 * std::abs(moment));
  EXPECT_LT(moment, -0.02);
}

TEST(FilmOnStrips, ThatDifferHoldsAJournalAtRestAsWithoutAFilm) {
  expect_held_at_rest_as_without_a_film(differing_case(0.0));
}

TEST(FilmOnStrips, ThatAreStaggeredOrFormedHoldsAJournalAtRestAsWithoutAFilm) {
  Case formed = differing_case(0.0);
  formed.top_foil.formed_radius = {FormedTo::seated};
  expect_held_at_rest_as_without_a_film(formed);
  Case staggered = staggered_case(0.0);
  expect_held_at_rest_as_without_a_film(staggered);
  staggered.top_foil.formed_radius = {FormedTo::seated};
  staggered.top_foil.seat_pressure = 200.0;
  expect_held_at_rest_as_without_a_film(staggered);
}

/// The positions of crests follow from the geometry of each strip alone.
TEST(FilmOnStrips, HasColumnsOverAllTheirCrests) {
  const Case input = staggered_case(0.0);
  const BearingModel bearing = make_film_bearing(input);
  const FilmPad& pad = bearing.film->pads.front();
  ASSERT_EQ(pad.stations, 3);
  ASSERT_EQ(pad.bumps(), 25);
  for (int support = 0; support < 75; ++support) {
    const int strip = bearing.lines[static_cast<std::size_t>(pad.line_over(support, 0))].strip;
    const PlacedPad alone = strip_of(bearing.placed.front(), strip);
    const Eigen::Matrix2Xd crests = outward_normals(alone.polar(alone.crests));
    const int column = pad.foil.supports[static_cast<std::size_t>(support)];
    EXPECT_LT((bearing.film->column_normals.col(column) - crests.col(support / 3)).norm(), 1e-12);
  }
}

/// The stagger of strips too low to touch anything has no effect: the same bearing with more columns kept over crests,
/// and a top foil that ends as far behind its last one.
TEST(FilmOnStrips, ThatTouchNothingIsNoneOfTheirStagger) {
  for (const int sixths : {1, 3}) {
    Case staggered = differing_case(0.1);
    staggered.film.columns_per_pitch = 6;
    staggered.bump_foil.bumps = 25;
    staggered.bump_foil.strip[1].height_errors = -1e-4;
    if (sixths == 3) {
      staggered.top_foil.formed_radius = {FormedTo::seated};
      staggered.top_foil.seat_pressure = 200.0;
    }
    Case level = staggered;
    staggered.bump_foil.strip[1].stagger = sixths / 6.0;
    level.top_foil.overhang = (0.5 + sixths / 6.0) * level.bump_foil.pitch.values.front();
    SharedBearing one, other;
    const RunningState found = state_of(staggered, one);
    const RunningState reference = state_of(level, other);
    expect_solved(*one, *found.last);
    ASSERT_EQ(one->film->columns(), other->film->columns());
    ASSERT_EQ(one->film->pads.front().stations, 2);
    const Vector strips = strip_loads(*one, found.last->contacts);
    EXPECT_EQ(strips[1], 0.0);
    // Each to the tolerance of its solver.
    EXPECT_LT((found.last->film.pressure - reference.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT((strips - strip_loads(*other, reference.last->contacts)).norm(), 1e-6 * some_load.norm());
    EXPECT_LT((*found.stiffness - *reference.stiffness).norm(), 1e-6 * reference.stiffness->norm());
    ASSERT_TRUE(found.held.sliding && reference.held.sliding);
    EXPECT_LT(std::abs(found.held.sliding->rate - reference.held.sliding->rate),
              1e-6 * std::abs(reference.held.sliding->rate));
  }
}

/// Exchanging the strips of both sides gives the mirror image of the film.
TEST(FilmOnStrips, IsMirroredWithThem) {
  Case input = staggered_case(0.1);
  SharedBearing bearing;
  const RunningState found = state_of(input, bearing);
  expect_solved(*bearing, *found.last);
  std::reverse(input.bump_foil.strip.begin(), input.bump_foil.strip.end());
  SharedBearing other;
  const RunningState mirrored = state_of(input, other);
  // Searches end when steps are below 1e-9.
  EXPECT_LT((mirrored.last->film.pressure.colwise().reverse() - found.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((mirrored.outcome->moment + found.outcome->moment).norm(), 1e-7 * found.outcome->moment.norm());
  EXPECT_LT(
      (strip_loads(*other, mirrored.last->contacts).reverse() - strip_loads(*bearing, found.last->contacts)).norm(),
      1e-6 * some_load.norm());
}

/// Derivatives of forces and moments by displacements and tilts.
TEST(FilmOnStrips, HasTheStiffnessOfDifferences) {
  for (const Case& input : {differing_case(0.0), staggered_case(0.0)}) {
    const BearingModel bearing = make_film_bearing(input);
    FilmStepper stepper(bearing);
    BearingState state;
    const double speed = speed_of_rpm(45000.0);
    ASSERT_EQ(start_from_ambient(stepper, {0.7 * bearing.clearance, 0.2 * bearing.clearance}, speed, state).status,
              Status::converged);
    OperatingPoint point = point_of(bearing, state, {});
    point.tilt.value = {2e-6, 1e-6};
    ASSERT_EQ(stepper.advance(point, state).status, Status::converged);
    expect_solved(bearing, state);
    expect_stiffness_of_differences(stepper, point, state);
  }
}

/// The mesh for error estimates has columns over all crests, twice six per pitch, and the state on it is that of a
/// bearing made with it.
TEST(FilmOnStrips, HasTheMeshErrorOfAMeshWithColumnsOverAllCrests) {
  Case input = staggered_case(0.0);
  input.film.rows = 2;
  EquilibriumResult result = run_equilibrium(input);
  estimate_mesh_errors(input, result);
  const RunningState& found = result.states.front();
  ASSERT_TRUE(found.mesh_error.has_value());
  input.film.columns_per_pitch *= 2;
  input.film.rows *= 2;
  SharedBearing finer;
  const RunningState on_finer = state_of(input, finer);
  const auto thinnest = [](const SharedBearing& of, const RunningState& state) {
    return of->film->scales.thickness * state.last->film.thickness.minCoeff();
  };
  // Second order: the error is 4/3 of the difference to a mesh of half the spacing.
  const double expected = 4.0 / 3.0 * std::abs(thinnest(result.bearing, found) - thinnest(finer, on_finer));
  EXPECT_NEAR(found.mesh_error->minimum_film_thickness, expected, 1e-5 * expected);
}

}  // namespace
}  // namespace bumpfoil
