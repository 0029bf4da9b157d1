#include "bumpfoil/bearing/film_stepper.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_runs.hpp"

namespace bumpfoil {
namespace {

constexpr FilmResolution four_rows{.columns_per_pitch = 4, .rows = 4};

TEST(FilmStepper, NeedsAFilm) {
  EXPECT_THROW(FilmStepper(make_foils(film_reference_case(four_rows))), Error);
}

TEST(FilmStepper, KeepsTheHistoryOfFriction) {
  const BearingModel bearing = film_reference_bearing(four_rows, 0.1);
  FilmStepper stepper(bearing);
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  const auto at = [&](double e) { return Eigen::Vector2d(e * bearing.clearance, 0.0); };
  ASSERT_EQ(start_from_ambient(stepper, at(0.5), speed, state).status, Status::converged);
  expect_solved(bearing, state);
  const double loaded = film_bearing_outcome(bearing, state).force.x();
  for (const double e : {0.8, 0.5}) {
    ASSERT_EQ(stepper.advance(OperatingPoint::held_at(at(e), speed), state).status, Status::converged);
    expect_solved(bearing, state);
  }
  EXPECT_LT(film_bearing_outcome(bearing, state).force.x(),
            0.95 * loaded);  // there and back: friction holds bumps down
}

TEST(FilmStepper, StiffnessIsTheDerivativeOfTheForce) {
  const double speed = speed_of_rpm(45000.0);
  const BearingModel bearing = film_reference_bearing(four_rows);
  FilmStepper stepper(bearing);
  BearingState state;
  const Eigen::Vector2d position(0.6 * bearing.clearance, 0.1 * bearing.clearance);
  ASSERT_EQ(start_from_ambient(stepper, position, speed, state).status, Status::converged);
  const auto motion = stepper.slow_motion(state);
  const auto K = stepper.stiffness(state);
  ASSERT_TRUE(motion && K && motion->stiffness == *K);
  double response = 0.0;      // of the foil
  constexpr double h = 1e-9;  // m; no contact changes its mode over so little
  for (const int axis : {0, 1}) {
    Eigen::Vector2d force[2];
    Vector deflection[2];
    for (const int side : {0, 1}) {
      BearingState moved = state;
      const Eigen::Vector2d there = position + (side == 0 ? -h : h) * Eigen::Vector2d::Unit(axis);
      ASSERT_EQ(stepper.advance(OperatingPoint::held_at(there, speed), moved).status, Status::converged);
      force[side] = film_bearing_outcome(bearing, moved).force;
      deflection[side] = bearing.film->scales.thickness * moved.film.deflection.row(0).transpose();
    }
    response = std::max(response, (deflection[1] - deflection[0]).cwiseAbs().maxCoeff() / (2.0 * h));
    // Forces of tens of newtons are good to 1e-9 N: 1e-6 of a few MN/m.
    EXPECT_LT(((force[1] - force[0]) / (2.0 * h) - K->col(axis)).norm(), 3e-6 * K->norm());
  }
  EXPECT_NEAR(motion->foil_response, response, 1e-5 * response);
}

/// The tangent is exact to first order: half the way departs from it by a quarter.
TEST(FilmStepper, DepartsFromItsTangentWithTheSquareOfTheWay) {
  const double speed = speed_of_rpm(45000.0);
  const BearingModel bearing = film_reference_bearing(four_rows);
  FilmStepper stepper(bearing);
  BearingState start;
  ASSERT_EQ(start_from_ambient(stepper, {0.6 * bearing.clearance, 0.0}, speed, start).status, Status::converged);
  FilmReport reports[2];
  for (const int i : {0, 1}) {
    BearingState state = start;
    const Eigen::Vector2d there((0.6 + 0.004 / (1 << i)) * bearing.clearance, 0.0);
    reports[i] = stepper.solve(stepper.move_to(OperatingPoint::held_at(there, speed)), state);
    ASSERT_EQ(reports[i].status, Status::converged);
  }
  EXPECT_NEAR(reports[0].predicted_change, 2.0 * reports[1].predicted_change, 1e-3 * reports[0].predicted_change);
  EXPECT_NEAR(reports[0].departure, 4.0 * reports[1].departure, 0.05 * reports[0].departure);
  EXPECT_GT(reports[1].departure, 1e-9);
}

TEST(FilmStepper, StatesAreApartByTheMostOfPlacePressureAndFoil) {
  const BearingModel bearing = film_reference_bearing(four_rows);
  FilmStepper stepper(bearing);
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, {0.3 * bearing.clearance, 0.0}, 0.0, state).status, Status::converged);
  BearingState other = state;
  other.position.y() += 0.25 * bearing.film->scales.thickness;
  EXPECT_NEAR(stepper.distance(state, other), 0.25, 1e-12);
  other.film.deflection(0, 1) -= 0.5;
  EXPECT_NEAR(stepper.distance(state, other), 0.5, 1e-12);
  other.film.pressure(1, 1) += 0.75;
  EXPECT_NEAR(stepper.distance(state, other), 0.75, 1e-12);
}

TEST(FilmStepper, StuckContactsAreStiffer) {
  const double speed = speed_of_rpm(45000.0);
  const BearingModel bearing = film_reference_bearing(four_rows, 0.1);
  FilmStepper stepper(bearing);
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, {0.8 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
  const auto slipping = stepper.stiffness(state);
  const auto stuck = stepper.stiffness(state, true);
  ASSERT_TRUE(slipping.has_value() && stuck.has_value());
  EXPECT_GT((*stuck)(0, 0), 1.1 * (*slipping)(0, 0));
}

TEST(FilmStepper, ImpedanceAtRestIsTheStiffness) {
  const double speed = speed_of_rpm(45000.0);
  const BearingModel bearing = film_reference_bearing(four_rows, 0.1);
  FilmStepper stepper(bearing);
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, {0.8 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
  for (const bool stuck : {false, true}) {
    const auto K = stepper.stiffness(state, stuck);
    const std::complex<double> whirl(0.0, speed);
    const auto Z = stepper.impedances(state, {0.0, whirl, std::conj(whirl)}, stuck);
    ASSERT_TRUE(K.has_value() && Z.has_value() && Z->size() == 3);
    EXPECT_LT(((*Z)[0] - *K).norm(), 1e-8 * K->norm());
    EXPECT_LT(((*Z)[1] - (*Z)[2].conjugate()).norm(), 1e-12 * K->norm());
    EXPECT_GT((*Z)[1].imag()(0, 0), 0.0);
    // Other requested results affect where the equations are factorised.
    const auto alone = stepper.impedances(state, {whirl / 7.0}, stuck);
    const auto with_others = stepper.impedances(state, {whirl / 7.0, 5.0 * whirl}, stuck);
    ASSERT_TRUE(alone.has_value() && with_others.has_value());
    EXPECT_LT(((*alone)[0] - (*with_others)[0]).norm(), 1e-8 * K->norm());
    EXPECT_GT(((*alone)[0] - (*Z)[0]).norm(), 1e-3 * K->norm());
  }
}

TEST(HeldMotions, AreStableWhereBothDecay) {
  HeldMotions motions;
  EXPECT_FALSE(motions.is_stable().has_value());
  motions.sliding = HeldMotion{.rate = {-1.0, 2.0}};
  EXPECT_FALSE(motions.is_stable().has_value());  // the other one may grow
  motions.stuck = HeldMotion{.rate = {-1.0, 0.0}};
  EXPECT_EQ(motions.is_stable(), true);
  motions.stuck->rate = 0.5;
  EXPECT_EQ(motions.is_stable(), false);
  motions.sliding.reset();
  EXPECT_EQ(motions.is_stable(), false);
}

TEST(HeldMotions, AreOneWhereNoContactSlips) {
  FilmStepper stepper(film_reference_bearing({.columns_per_pitch = 4, .rows = 4}));
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, {0.5 * stepper.bearing().clearance, 0.0}, speed_of_rpm(-45000.0), state).status,
            Status::converged);
  const HeldMotions motions = stepper.held_motions(state);
  const auto alone = stepper.held_motion(state, true);
  ASSERT_TRUE(motions.sliding && motions.stuck && alone);
  EXPECT_EQ(motions.sliding->rate, motions.stuck->rate);
  EXPECT_LT(std::abs(alone->rate - motions.stuck->rate), 1e-9 * std::abs(alone->rate));
}

}  // namespace
}  // namespace bumpfoil
