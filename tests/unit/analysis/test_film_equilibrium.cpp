#include "bumpfoil/analysis/film_equilibrium.hpp"

#include <gtest/gtest.h>

#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

const double speed = speed_of_rpm(45000.0);

TEST(FilmBearingSolver, StiffnessIsTheDerivativeOfTheForce) {
  const FilmBearing bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 4});
  FilmBearingSolver solver(bearing);
  FilmBearingState state;
  const Eigen::Vector2d position(0.6 * bearing.clearance, 0.1 * bearing.clearance);
  ASSERT_EQ(solver.cold_start(position, speed, state).status, FilmStatus::converged);
  const auto K = solver.stiffness(state);
  ASSERT_TRUE(K.has_value());
  constexpr double h = 1e-9;  // m; no contact changes its mode over so little
  for (const int axis : {0, 1}) {
    Eigen::Vector2d force[2];
    for (const int side : {0, 1}) {
      FilmBearingState moved = state;
      const Eigen::Vector2d there = position + (side == 0 ? -h : h) * Eigen::Vector2d::Unit(axis);
      ASSERT_EQ(solver.solve(there, speed, state.contact, moved).status, FilmStatus::converged);
      force[side] = film_bearing_outcome(bearing, moved).force;
    }
    // Forces of tens of newtons are good to 1e-9 N: 1e-6 of a few MN/m.
    EXPECT_LT(((force[1] - force[0]) / (2.0 * h) - K->col(axis)).norm(), 3e-6 * K->norm());
  }
}

TEST(FilmBearingSolver, StuckContactsAreStiffer) {
  const FilmBearing bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 4}, 0.1);
  FilmBearingSolver solver(bearing);
  FilmBearingState state;
  ASSERT_EQ(solver.cold_start({0.8 * bearing.clearance, 0.0}, speed, state).status, FilmStatus::converged);
  const auto slipping = solver.stiffness(state);
  const auto stuck = solver.stiffness(state, true);
  ASSERT_TRUE(slipping.has_value() && stuck.has_value());
  EXPECT_GT((*stuck)(0, 0), 1.1 * (*slipping)(0, 0));
}

TEST(FilmEquilibrium, CarriesTheLoad) {
  const FilmBearing bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 4});
  FilmBearingSolver solver(bearing);
  FilmBearingState state;
  ASSERT_EQ(solver.cold_start({0.6 * bearing.clearance, 0.0}, speed, state).status, FilmStatus::converged);
  const Eigen::Vector2d load(40.0, 0.0);
  ASSERT_EQ(find_equilibrium(solver, bearing, load, 0.8 * speed, 4, state).status, FilmStatus::converged);
  EXPECT_EQ(state.speed, 0.8 * speed);
  EXPECT_LT((film_bearing_outcome(bearing, state).force - load).norm(), 1e-6);  // N
  EXPECT_GT(state.position.y(), 0.0);  // the journal leans in the sense of rotation
}

}  // namespace
}  // namespace bumpfoil
