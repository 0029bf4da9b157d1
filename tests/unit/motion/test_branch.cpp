#include "bumpfoil/motion/branch.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_runs.hpp"

namespace bumpfoil {
namespace {

constexpr FilmResolution branch_resolution{.columns_per_pitch = 4, .rows = 4};

TEST(Branch, ColdStartsAndFollowsToSolutions) {
  const BearingModel bearing = film_reference_bearing(branch_resolution);
  FilmStepper stepper(bearing);
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  const Eigen::Vector2d position(0.7 * bearing.clearance, 0.0);
  ASSERT_EQ(start_from_ambient(stepper, position, speed, state).status, Status::converged);
  EXPECT_EQ(state.position, position);
  expect_solved(bearing, state);
  ASSERT_EQ(follow(stepper, OperatingPoint::held_at(2.0 * position, speed), state).status, Status::converged);
  EXPECT_EQ(state.position, 2.0 * position);
  expect_solved(bearing, state);
  ASSERT_EQ(follow(stepper, OperatingPoint::held_at(2.0 * position, 0.5 * speed), state).status, Status::converged);
  EXPECT_EQ(state.speed, 0.5 * speed);
  expect_solved(bearing, state);
}

TEST(Branch, SaysWhenThereIsNoRoomAndLeavesTheStateAsItWas) {
  const BearingModel bearing = film_reference_bearing(branch_resolution);
  FilmStepper stepper(bearing);
  const BearingState rest = resting(bearing, Eigen::Vector2d::Zero(), 0.0);
  BearingState state = rest;
  const Eigen::Vector2d outside(1.2 * bearing.clearance, 0.0);
  EXPECT_EQ(start_from_ambient(stepper, outside, 1000.0, state).status, Status::no_room);
  EXPECT_EQ(state.film.pressure, rest.film.pressure);
  EXPECT_EQ(state.position, rest.position);
  // A foil that deflects on the way makes room.
  ASSERT_EQ(follow(stepper, OperatingPoint::held_at(outside, 4000.0), state).status, Status::converged);
  EXPECT_EQ(state.position, outside);
}

/// Gas enters at the weld; the load moves the journal away from it. The check uses the equations of the final state
/// only, independent of the path.
TEST(Branch, ClosesTheClearanceOfAJournalAtWork) {
  const double speed = speed_of_rpm(-45000.0);
  const Eigen::Vector2d load(150.0, 0.0);
  for (const double clearance : {5e-6, 0.0, -3e-6}) {
    for (const double f : {0.0, 0.1}) {
      if (clearance < 0.0 && f > 0.0) continue;  // touches
      SCOPED_TRACE(testing::Message() << clearance << ' ' << f);
      Case input = film_reference_case(branch_resolution, f);
      input.bearing.radial_clearance = clearance;
      const BearingModel bearing = make_film_bearing(input);
      FilmStepper stepper(bearing);
      BearingState state;
      const double clearance_offset = 10e-6 - clearance;
      ASSERT_EQ(start_from_ambient(stepper, {5e-6, 0.0}, speed, state, clearance_offset).status, Status::converged);
      EXPECT_EQ(state.clearance_offset, clearance_offset);
      OperatingPoint loaded = OperatingPoint::loaded_by(load, speed, clearance_offset);
      ASSERT_EQ(follow(stepper, loaded, state).status, Status::converged);
      EXPECT_EQ(state.clearance_offset, clearance_offset);
      loaded.clearance_offset = 0.0;
      ASSERT_EQ(follow(stepper, loaded, state).status, Status::converged);
      EXPECT_EQ(state.clearance_offset, 0.0);
      expect_solved(bearing, state);
      EXPECT_LT((film_force(*bearing.film, state.film.pressure) - load).norm(), 1e-7);  // N
      EXPECT_GT(state.position.x(), -clearance);
      if (clearance <= 0.0) {
        EXPECT_GT(bump_loads(bearing, state).minCoeff(), -1e-9);  // N
        continue;
      }
      if (f > 0.0) continue;
      // A positive clearance needs no clearance offset: the same state.
      BearingState direct;
      ASSERT_EQ(start_from_ambient(stepper, {0.6 * clearance, 0.0}, speed, direct).status, Status::converged);
      ASSERT_EQ(follow(stepper, loaded, direct).status, Status::converged);
      EXPECT_LT((direct.position - state.position).norm(), 1e-8 * clearance);
      EXPECT_LT((direct.film.pressure - state.film.pressure).cwiseAbs().maxCoeff(), 1e-7);
    }
  }
}

TEST(Branch, SaysWhenSurfacesTouch) {
  const BearingModel bearing = film_reference_bearing(branch_resolution);
  FilmStepper stepper(bearing, {.newton = {.thickness_floor = 0.5}});
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  ASSERT_EQ(start_from_ambient(stepper, {0.2 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
  EXPECT_EQ(follow(stepper, OperatingPoint::held_at({0.9 * bearing.clearance, 0.0}, speed), state).status,
            Status::touchdown);
  EXPECT_GE(state.film.thickness.minCoeff(), 0.5);  // the last good state
  EXPECT_GT(state.position.x(), 0.2 * bearing.clearance);
}

/// Near the end of a branch no tangent leads on: under a load beyond it the foil jumps once and reports it. (Newton's
/// method can also reach a state there in one solve, but an arbitrary one.)
TEST(Branch, JumpsWhereTheBranchUnderALoadEnds) {
  const double speed = speed_of_rpm(45000.0);
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 6, .rows = 8}, 0.1);
  const auto end_of = [&](int steps) {
    FilmStepper stepper(bearing);
    BearingState state;
    EXPECT_EQ(start_from_ambient(stepper, {0.6 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
    const Eigen::Vector2d from = film_force(*bearing.film, state.film.pressure);
    int jumps = 0;
    for (int i = 1; i <= steps; ++i) {
      const Eigen::Vector2d load = from + static_cast<double>(i) / steps * (Eigen::Vector2d(20.0, 0.0) - from);
      const FilmReport report = follow(stepper, OperatingPoint::loaded_by(load, speed), state);
      EXPECT_EQ(report.status, Status::converged);
      jumps += report.jumps;
    }
    return std::pair(jumps, film_bearing_outcome(bearing, state).loaded_bumps);
  };
  EXPECT_EQ(end_of(10), end_of(30));
  EXPECT_GT(end_of(10).first, 0);
}

TEST(Branch, FindsThePositionThatCarriesALoad) {
  const BearingModel bearing = film_reference_bearing(branch_resolution);
  FilmStepper stepper(bearing);
  BearingState state;
  const double speed = speed_of_rpm(45000.0);
  ASSERT_EQ(start_from_ambient(stepper, {0.6 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
  const Eigen::Vector2d load(40.0, 0.0);
  const BearingState start = state;
  ASSERT_EQ(follow(stepper, OperatingPoint::loaded_by(load, 0.8 * speed), state).status, Status::converged);
  EXPECT_EQ(state.speed, 0.8 * speed);
  // Newton's last step changed P by less than 1e-9: about 1e-8 N.
  EXPECT_LT((film_bearing_outcome(bearing, state).force - load).norm(), 1e-7);
  EXPECT_GT(state.position.y(), 0.0);  // the journal is displaced in the sense of rotation
  expect_solved(bearing, state);
}

}  // namespace
}  // namespace bumpfoil
