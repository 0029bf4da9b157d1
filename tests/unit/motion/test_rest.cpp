#include "bumpfoil/motion/rest.hpp"

#include <gtest/gtest.h>

#include "support/film_runs.hpp"

namespace bumpfoil {
namespace {

constexpr FilmResolution rest_resolution{.columns_per_pitch = 4, .rows = 4};

/// Released, the journal comes to rest where the film carries its load. The elapsed time is what the film needs.
TEST(Rest, IsWhereTheJournalCarriesItsLoad) {
  const BearingModel bearing = film_reference_bearing(rest_resolution, 0.1);
  FilmStepper stepper(bearing);
  BearingState start;
  const double speed = speed_of_rpm(45000.0);
  ASSERT_EQ(start_from_ambient(stepper, {0.6 * bearing.clearance, 0.0}, speed, start).status, Status::converged);
  EXPECT_GT(start.time, FilmBearingOptions().last_time_step);
  const Eigen::Vector2d load(40.0, 0.0);
  BearingState released = start;
  ASSERT_EQ(settle(stepper, OperatingPoint::loaded_by(load, 0.8 * speed), released).status, Status::converged);
  // Newton's last step changed P by less than 1e-9: about 1e-8 N.
  EXPECT_LT((film_bearing_outcome(bearing, released).force - load).norm(), 1e-7);
  EXPECT_EQ(released.speed, 0.8 * speed);
  EXPECT_EQ(released.slip_origin, start.contacts.x);
  EXPECT_GT(released.time, start.time);
  expect_solved(bearing, released);
}

/// The march continues with steps of any length until changes are below the limit.
TEST(Rest, ComesLaterWhereLessIsRest) {
  const BearingModel bearing = film_reference_bearing(rest_resolution);
  const auto time_until_rest = [&](double resting_change) {
    FilmStepper stepper(bearing, {.last_time_step = 0.0, .resting_change = resting_change});
    BearingState state;
    EXPECT_EQ(start_from_ambient(stepper, {0.6 * bearing.clearance, 0.0}, 4000.0, state).status, Status::converged);
    return state.time;
  };
  EXPECT_GT(time_until_rest(1e-5), 1.1 * time_until_rest(1e-2));
}

TEST(Rest, StopsWhenTold) {
  const BearingModel bearing = film_reference_bearing(rest_resolution);
  int solves = 0;
  FilmStepper stepper(bearing, {.keep_going = [&] { return ++solves < 5; }});
  BearingState state;
  EXPECT_EQ(start_from_ambient(stepper, {0.6 * bearing.clearance, 0.0}, 4000.0, state).status, Status::interrupted);
  EXPECT_EQ(solves, 5);
}

}  // namespace
}  // namespace bumpfoil
