#include "bumpfoil/experiments/film/wall_film.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/validation.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_cases.hpp"

namespace bumpfoil {
namespace {

Case wall_case() {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 6});
  input.settings.set(EquilibriumSettings{
      .speeds = {speed_of_rpm(45000.0)}, .positions = {{12e-6, 0.0}, {15e-6, 5e-6}}, .path = FilmPath::position_ray});
  return input;
}

/// The films are those of the solver for rigid walls; forces are in the coordinates of the bearing.
TEST(WallFilm, IsThatOfTheRigidBearing) {
  const Case input = wall_case();
  const EquilibriumResult result = run_wall_films(input);
  ASSERT_EQ(result.states.size(), 2U);
  EXPECT_TRUE(result.converged());
  EXPECT_FALSE(result.bearing->has_foils());
  for (const RunningState& state : result.states) {
    const BearingModel& bearing = *result.bearing;
    const SolvedFilm film =
        solve_rigid_film(film_equation(*bearing.film, bearing.film->pads.front(), state.requested.speed),
                         undeformed_thickness(bearing, state.requested.journal));
    EXPECT_LT((film.film.pressure - state.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(state.outcome->torque_of_moments, state.outcome->torque, 1e-3 * state.outcome->torque);
    EXPECT_NEAR(state.outcome->dissipation, state.outcome->power, 1e-3 * state.outcome->power);
    EXPECT_TRUE(state.stiffness);
    EXPECT_FALSE(state.stuck_stiffness);
  }
}

/// The supply pressure at the free end exceeds ambient pressure and carries part of the load.
TEST(WallFilm, IsFedAtItsFreeEnd) {
  Case input = wall_case();
  const double outflow = run_wall_films(input).states[0].outcome->flows.end;
  input.film.inlet_pressure = 1.1 * input.gas.ambient_pressure;
  const EquilibriumResult fed = run_wall_films(input);
  ASSERT_TRUE(fed.converged());
  const Matrix& pressure = fed.states[0].last->film.pressure;
  EXPECT_NEAR(pressure(0, pressure.cols() - 1), 1.1, 1e-15);
  EXPECT_NEAR(pressure(0, 0), 1.0, 1e-15);
  EXPECT_NE(fed.states[0].outcome->flows.end, outflow);
  input.film.closed = true;
  EXPECT_THROW(run_wall_films(input), Error);
}

/// Gas flows from side to side around a centred journal, at ambient pressure
/// 2 pi R h^3 (p_l^2 - p_r^2) / (24 mu L p_a); p^2 falls linearly.
TEST(WallFilm, LetsGasFlowFromSideToSide) {
  Case input = wall_case();
  input.film.closed = true;
  input.settings.get<EquilibriumSettings>().positions = {{0.0, 0.0}};
  const double ambient = input.gas.ambient_pressure;
  input.film.side_pressure = {1.3 * ambient, 1.1 * ambient};
  const EquilibriumResult result = run_wall_films(input);
  ASSERT_TRUE(result.converged());
  const RunningState& state = result.states.front();
  const double R = input.bearing.radius;
  const double h = input.bearing.radial_clearance;
  const double flow = 2.0 * std::numbers::pi * R * h * h * h * (1.3 * 1.3 - 1.1 * 1.1) * ambient /
                      (24.0 * *input.gas.viscosity * input.bearing.axial_length);
  const FilmFlows& flows = state.outcome->flows;
  EXPECT_NEAR(flows.right_side, flow, 1e-9 * flow);
  EXPECT_NEAR(flows.sides, 0.0, 1e-9 * flow);
  const Matrix& P = state.last->film.pressure;
  EXPECT_NEAR(P(0, 5), 1.3, 1e-15);
  EXPECT_NEAR(P(6, 5) * P(6, 5), 0.5 * (1.3 * 1.3 + 1.1 * 1.1), 1e-9);
  EXPECT_NEAR(P(12, 5), 1.1, 1e-15);
  // Equal pressures at both sides: half the width is sufficient.
  input.film.side_pressure = {1.3 * ambient, 1.3 * ambient};
  const EquilibriumResult fed = run_wall_films(input);
  EXPECT_FALSE(fed.bearing->film->tilts());
  EXPECT_NEAR(fed.states.front().last->film.pressure.minCoeff(), 1.3, 1e-9);
}

/// In a gap from h_l to h_r over the width, p^2 falls with the integral of 1/h^3, which is
/// L (h_l + h_r) / (2 h_l^2 h_r^2) for linear h.
TEST(WallFilm, LetsGasFlowThroughAConicalGap) {
  Case input = wall_case();
  input.film.closed = true;
  input.settings.get<EquilibriumSettings>().positions = {{0.0, 0.0}};
  const double ambient = input.gas.ambient_pressure;
  input.film.side_pressure = {1.3 * ambient, 1.1 * ambient};
  const double h = input.bearing.radial_clearance;
  input.width.conicity = 0.4 * h;
  const double left = 0.8 * h;
  const double right = 1.2 * h;
  const double flow = 2.0 * std::numbers::pi * input.bearing.radius * (1.3 * 1.3 - 1.1 * 1.1) * ambient * 2.0 * left *
                      left * right * right /
                      (24.0 * *input.gas.viscosity * input.bearing.axial_length * (left + right));
  double error[2];
  for (const int refined : {0, 1}) {
    input.film.rows = refined ? 12 : 6;
    const EquilibriumResult result = run_wall_films(input);
    ASSERT_TRUE(result.converged());
    EXPECT_TRUE(result.bearing->film->tilts());  // whole width
    error[refined] = result.states.front().outcome->flows.right_side / flow - 1.0;
  }
  EXPECT_LT(std::abs(error[1]), 3e-3);
  EXPECT_NEAR(error[0] / error[1], 4.0, 0.2);  // second order
}

/// Forces and moments under a small additional tilt agree with the stiffness.
TEST(WallFilm, IsTiltedByMoments) {
  Case input = wall_case();
  input.settings.get<EquilibriumSettings>().positions = {{12e-6, 3e-6}};
  constexpr double slope = 3e-4;
  constexpr double h = 1e-8;
  const auto outcome = [&](double a, double b) {
    Case tilted = input;
    tilted.width.tilt = {a, b};
    return run_wall_films(tilted).states.front();
  };
  const RunningState state = outcome(slope, 0.5 * slope);
  ASSERT_TRUE(state.found() && state.stiffness);
  EXPECT_GT(state.outcome->moment.x(), 0.0);  // against the tilt
  // The contribution of the tilt to the balance of moments about the axis is 1.6e-3 of the torque.
  EXPECT_NEAR(state.outcome->torque_of_moments, state.outcome->torque, 2e-4 * state.outcome->torque);
  EXPECT_LT((outcome(-slope, -0.5 * slope).outcome->moment + state.outcome->moment).norm(),
            1e-9 * state.outcome->moment.norm());
  for (const Eigen::Index axis : {0, 1}) {
    const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(axis);
    const FilmBearingOutcome plus = *outcome(slope + step.x(), 0.5 * slope + step.y()).outcome;
    const FilmBearingOutcome minus = *outcome(slope - step.x(), 0.5 * slope - step.y()).outcome;
    Eigen::Vector4d change;
    change << plus.force - minus.force, plus.moment - minus.moment;
    const Eigen::Vector4d column = state.stiffness->col(2 + axis);
    EXPECT_LT((change / (2.0 * h) - column).norm(), 1e-5 * column.norm());
  }
}

TEST(WallFilm, HasSmoothWalls) {
  Case input = wall_case();
  input.asperity = AsperitySettings{.sigma = 0.3e-6, .pressure_factor = 2.4e8, .friction = 0.2};
  EXPECT_THROW(run_wall_films(input), Error);
}

/// Reported before a run, as `bumpfoil check` promises.
TEST(WallFilm, HasNeitherPadsNorEdgesThatAreNotThere) {
  const auto errors = [](const auto& change) {
    Case input = wall_case();
    change(input);
    return find_errors(input, {"film"}).size();
  };
  EXPECT_EQ(errors([](Case&) {}), 0U);
  EXPECT_EQ(errors([](Case& input) { input.pads.resize(1); }), 1U);
  EXPECT_EQ(errors([](Case& input) { input.settings.get<EquilibriumSettings>().positions.clear(); }), 1U);
  EXPECT_EQ(errors([](Case& input) {
              input.film.closed = true;
              input.bearing.taper = 1e-6;
              input.film.inlet_pressure = 110e3;
            }),
            2U);
}

/// The wall ends where the foils that it replaces end, at the sum of their pitches, which may vary.
TEST(WallFilm, IsAsLongAsTheFoils) {
  Case input = wall_case();
  input.bump_foil.pitch = PerBump(4.3e-3, 4.8e-3, Grading::linear);
  const BearingModel bearing = make_wall_bearing(input);
  EXPECT_NEAR(bearing.film->pads.front().foil.mesh.angles().tail(1)[0], 26.0 * 4.55e-3 / input.bearing.radius, 1e-12);
}

/// A closed bearing is axisymmetric.
TEST(WallFilm, ClosedWallTurnsWithItsLoad) {
  Case input = wall_case();
  input.film.closed = true;
  input.settings.get<EquilibriumSettings>().positions = {{15e-6, 0.0}, {0.0, 15e-6}};
  const EquilibriumResult result = run_wall_films(input);
  ASSERT_TRUE(result.converged());
  const Eigen::Vector2d along_x = result.states[0].outcome->force;
  const Eigen::Vector2d along_y = result.states[1].outcome->force;
  // 104 columns are a multiple of four: a quarter turn maps the mesh onto itself.
  EXPECT_NEAR(along_y.x(), -along_x.y(), 1e-7);
  EXPECT_NEAR(along_y.y(), along_x.x(), 1e-7);
  EXPECT_GT(result.states[0].outcome->attitude_angle, 0.5);
}

TEST(WallFilm, SpringsYield) {
  Case input = wall_case();
  const double rigid = run_wall_films(input).states[0].outcome->force.norm();
  for (const FilmWall wall : {FilmWall::springs, FilmWall::rigid_across}) {
    input.film.wall = wall;
    input.film.wall_stiffness = 5e9;
    const EquilibriumResult result = run_wall_films(input);
    ASSERT_TRUE(result.converged());
    const RunningState& state = result.states[0];
    EXPECT_LT(state.outcome->force.norm(), 0.97 * rigid);
    EXPECT_NEAR(state.outcome->torque_of_moments, state.outcome->torque, 2e-3 * state.outcome->torque);
    // H - H_rigid = (p - pa)/k, at the mid-plane of a column, or with the mean over it.
    const BearingModel& bearing = *result.bearing;
    const Matrix yield = bearing.film->scales.thickness *
                         (state.last->film.thickness - undeformed_thickness(bearing, state.requested.journal));
    const auto p = state.last->film.pressure.col(50);
    const double mean = (0.5 * p[0] + p.segment(1, 5).sum() + 0.5 * p[6]) / 6.0;
    const double pressing = wall == FilmWall::springs ? p[0] : mean;
    EXPECT_NEAR(yield(0, 50), 101325.0 * (pressing - 1.0) / 5e9, 1e-12);
  }
}

TEST(WallFilm, KnowsNoWavesOfTheJournalAndNoStepInAClosedWall) {
  Case wavy = wall_case();
  wavy.bearing.journal.waves = {{3, 5e-6, 0.0}};
  EXPECT_THROW(run_wall_films(wavy), Error);
  Case tapered = wall_case();
  tapered.bearing.taper = 2e-6;
  EXPECT_NO_THROW(run_wall_films(tapered));
  tapered.film.closed = true;
  EXPECT_THROW(run_wall_films(tapered), Error);
}

TEST(WallFilm, HasNoPads) {
  Case input = wall_case();
  input.bump_foil.bumps = 7;
  input.pads.resize(3);
  EXPECT_THROW(run_wall_films(input), Error);
}

TEST(WallFilm, WantsPositions) {
  Case input = wall_case();
  EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  equilibrium.positions.clear();
  equilibrium.loads = {{10.0, 0.0}};
  equilibrium.path = FilmPath::load_ramp;
  EXPECT_THROW(run_wall_films(input), Error);
}

}  // namespace
}  // namespace bumpfoil
