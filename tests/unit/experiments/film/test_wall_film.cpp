#include "bumpfoil/experiments/film/wall_film.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/core/error.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_cases.hpp"

namespace bumpfoil {
namespace {

Case wall_case() {
  Case input = film_reference_case({.columns_per_pitch = 4, .rows = 6});
  input.equilibrium = EquilibriumSettings{
      .speeds = {speed_of_rpm(45000.0)}, .positions = {{12e-6, 0.0}, {15e-6, 5e-6}}, .path = FilmPath::position_ray};
  return input;
}

/// The films are those of the solver for rigid walls, and forces are in the plane of the bearing.
TEST(WallFilm, IsThatOfTheRigidBearing) {
  const Case input = wall_case();
  const EquilibriumResult result = run_wall_films(input);
  ASSERT_EQ(result.states.size(), 2U);
  EXPECT_TRUE(result.converged());
  EXPECT_FALSE(result.bearing->has_foils());
  for (const RunningState& state : result.states) {
    const FilmBearing& bearing = *result.bearing;
    const SolvedFilm film = solve_rigid_film(film_equation(bearing, bearing.pads.front(), state.asked.speed),
                                             bearing.undeformed_thickness(state.asked.journal));
    EXPECT_LT((film.film.pressure - state.last->film.pressure).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(state.outcome->torque_of_moments, state.outcome->torque, 1e-3 * state.outcome->torque);
    EXPECT_NEAR(state.outcome->dissipation, state.outcome->power, 1e-3 * state.outcome->power);
    EXPECT_TRUE(state.stiffness);
    EXPECT_FALSE(state.stuck_stiffness);
  }
}

/// What feeds the free end is above ambient there, and carries a part of the load.
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

TEST(WallFilm, HasSmoothWalls) {
  Case input = wall_case();
  input.asperity = AsperitySettings{.sigma = 0.3e-6, .pressure_factor = 2.4e8, .friction = 0.2};
  EXPECT_THROW(run_wall_films(input), Error);
}

/// The foils that the wall stands for end where their pitches add up to, whatever each is.
TEST(WallFilm, IsAsLongAsTheFoils) {
  Case input = wall_case();
  input.bump_foil.pitch = PerBump(4.3e-3, 4.8e-3, Grading::linear);
  const FilmBearing bearing = make_wall_bearing(input);
  EXPECT_NEAR(bearing.pads.front().foil.mesh.angles().tail(1)[0], 26.0 * 4.55e-3 / input.bearing.radius, 1e-12);
}

/// A closed bearing knows no place on its circumference.
TEST(WallFilm, ClosedWallTurnsWithItsLoad) {
  Case input = wall_case();
  input.film.closed = true;
  input.equilibrium->positions = {{15e-6, 0.0}, {0.0, 15e-6}};
  const EquilibriumResult result = run_wall_films(input);
  ASSERT_TRUE(result.converged());
  const Eigen::Vector2d along_x = result.states[0].outcome->force;
  const Eigen::Vector2d along_y = result.states[1].outcome->force;
  // 104 columns are a multiple of four: the mesh turns into itself.
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
    // H - H_rigid = (p - pa)/k, at the mid-plane of a column, or on the mean over it.
    const FilmBearing& bearing = *result.bearing;
    const Matrix yield =
        bearing.scales.thickness * (state.last->film.thickness - bearing.undeformed_thickness(state.asked.journal));
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
  input.equilibrium->positions.clear();
  input.equilibrium->loads = {{10.0, 0.0}};
  input.equilibrium->path = FilmPath::load_ramp;
  EXPECT_THROW(run_wall_films(input), Error);
}

}  // namespace
}  // namespace bumpfoil
