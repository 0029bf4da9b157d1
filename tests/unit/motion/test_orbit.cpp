#include "bumpfoil/motion/orbit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "bumpfoil/motion/response.hpp"
#include "bumpfoil/rotor/unbalance.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_motions.hpp"

namespace bumpfoil {
namespace {

/// A point mass under 100 N, with an unbalance that moves it by about 0.3 um.
class OrbitSearch : public ::testing::Test {
 protected:
  [[nodiscard]] MachineState start() {
    MachineState state = stepper_.at_rest({rest_}, load_);
    const auto motion = linear_response(stepper_.rotor(), {{bearing_, rest_}},
                                        unbalance_force(plane(), unbalance_, speed_), {0.0, std::abs(speed_)});
    EXPECT_TRUE(motion.has_value());
    if (motion) add_motion(stepper_, *motion, state);
    return state;
  }
  [[nodiscard]] const RotorStation& plane() const { return stepper_.rotor().bearings.front(); }

  double speed_ = speed_of_rpm(-45000.0);
  Eigen::Vector2d load_{100.0, 0.0};
  Unbalance unbalance_{.amount = 0.2e-6};
  FilmStepper bearing_{film_reference_bearing({4, 3})};
  MachineStepper stepper_{make_point_mass(1.0), {&bearing_}};
  BearingState rest_ = state_under(bearing_, load_, speed_);
  RotorForces forces_ = [this](const RotorInstant& now) -> Eigen::VectorXd {
    return load_ + unbalance_force(plane(), unbalance_, now.angle, now.speed, now.acceleration);
  };
};

/// Two more turns, marched in time, repeat the orbit: checks the search and the reported results.
TEST_F(OrbitSearch, FindsWhatRepeatsItself) {
  constexpr int steps = 40;
  const Orbit orbit = find_orbit(stepper_, forces_, start(), {.steps_per_turn = steps, .tolerance = 1e-8});
  ASSERT_EQ(orbit.status, Status::converged);
  EXPECT_LT(orbit.change, 1e-8);
  EXPECT_LT(orbit.turns, 30);  // disturbances decay by 7 % per turn: 200 turns without extrapolation
  EXPECT_FALSE(orbit.multipliers.empty());
  EXPECT_NEAR(std::abs(orbit.multipliers.front()), 0.93, 0.02);
  MachineState state = orbit.state;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Vector2d square = Eigen::Vector2d::Zero();
  double thinnest = 1.0;
  for (int i = 0; i < 2 * steps; ++i) {
    const double dt = 2.0 * std::numbers::pi / (std::abs(speed_) * steps);
    ASSERT_EQ(stepper_.advance({.dt = dt, .speed = speed_}, forces_, state).status, Status::converged);
    sum += state.rotor.y;
    square += (state.rotor.y - orbit.bearings.front().mean).cwiseAbs2();
    thinnest = std::min(thinnest, state.bearings.front().film.thickness.minCoeff());
  }
  EXPECT_LT((state.rotor.y - orbit.state.rotor.y).norm(), 1e-7 * bearing_.film().scales.thickness);
  EXPECT_LT((sum / (2 * steps) - orbit.bearings.front().mean).norm(), 1e-12);
  EXPECT_NEAR(thinnest * bearing_.film().scales.thickness, orbit.turn.front().thinnest, 1e-12);
  // Parseval's theorem: half the sum of squared amplitudes is the mean square; harmonics above the second are small.
  const StationOrbit& found = orbit.bearings.front();
  const Eigen::Vector2d harmonics = 0.5 * (found.once.cwiseAbs2() + found.twice.cwiseAbs2());
  EXPECT_LT((square / (2 * steps) - harmonics).norm(), 1e-5 * harmonics.norm());
  EXPECT_GT(found.once.norm(), 1e-7);
  EXPECT_LT(found.twice.norm(), 1e-2 * found.once.norm());
  EXPECT_LT((found.half_peak_to_peak - found.once.cwiseAbs()).norm(), 1e-2 * found.once.norm());
}

/// A search that starts on the orbit has nothing to find: its multipliers follow from a disturbance.
TEST_F(OrbitSearch, DisturbsWhatItHasFoundAtOnce) {
  const OrbitOptions options{.steps_per_turn = 40, .tolerance = 1e-6};
  const Orbit orbit = find_orbit(stepper_, forces_, start(), options);
  ASSERT_EQ(orbit.status, Status::converged);
  MachineState end = orbit.state;
  end.time = 0.0;
  const Orbit again = find_orbit(stepper_, forces_, end, options);
  ASSERT_EQ(again.status, Status::converged);
  EXPECT_EQ(again.turns, 2 + 2 + 6);  // find and record, settle after the disturbance, determine multipliers
  EXPECT_LT(again.change, 1e-6);
  ASSERT_FALSE(again.multipliers.empty());
  EXPECT_NEAR(std::abs(again.multipliers.front()), std::abs(orbit.multipliers.front()), 0.01);
  // This is the orbit as found, not the remainder of the disturbance.
  EXPECT_LT((again.state.rotor.y - orbit.state.rotor.y).norm(), 1e-5 * bearing_.film().scales.thickness);
  EXPECT_LT((again.bearings[0].once - orbit.bearings[0].once).norm(), 1e-4 * orbit.bearings[0].once.norm());
}

/// The orbit at a nearby speed is a better start than the linear response, and leads to the same orbit.
TEST_F(OrbitSearch, FollowsTheOrbitToAnotherSpeed) {
  const OrbitOptions options{.steps_per_turn = 40};
  unbalance_.amount = 2e-6;  // 3 um: the orbit is not small
  const MachineState before = start();
  const Orbit old = find_orbit(stepper_, forces_, before, options);
  ASSERT_EQ(old.status, Status::converged);
  speed_ = speed_of_rpm(-44900.0);
  rest_ = state_under(bearing_, load_, speed_);
  const MachineState linear = start();
  const Orbit orbit = find_orbit(stepper_, forces_, linear, options);
  const std::optional<MachineState> moved = moved_orbit(linear, old.state, before);
  ASSERT_TRUE(moved.has_value());
  EXPECT_EQ(moved->speed, speed_);
  EXPECT_EQ(moved->last_dt, 0.0);
  // Compared by the state after whole turns, it is closer to the orbit of its speed than the linear start is.
  EXPECT_LT((moved->rotor.y - orbit.state.rotor.y).norm(), 0.2 * (linear.rotor.y - orbit.state.rotor.y).norm());
  const Orbit followed = find_orbit(stepper_, forces_, *moved, options);
  ASSERT_EQ(followed.status, Status::converged);
  EXPECT_LE(followed.turns, orbit.turns);
  EXPECT_LT((followed.bearings[0].once - orbit.bearings[0].once).norm(), 1e-4 * orbit.bearings[0].once.norm());
  // A difference as large as the film leaves no film.
  MachineState far = old.state;
  far.bearings[0].film.thickness.array() -= 1.1 * far.bearings[0].film.thickness.maxCoeff();
  EXPECT_FALSE(moved_orbit(linear, far, before).has_value());
}

TEST_F(OrbitSearch, SaysWhereItFindsNone) {
  const Orbit orbit = find_orbit(stepper_, forces_, start(), {.steps_per_turn = 40, .max_turns = 3});
  EXPECT_EQ(orbit.status, Status::not_converged);
  EXPECT_EQ(orbit.turns, 4);
  EXPECT_GT(orbit.change, 1e-7);
  EXPECT_EQ(orbit.bearings.size(), 1U);  // of the last turn
  EXPECT_TRUE(orbit.multipliers.empty());

  const MachineState begin = start();
  const Orbit stopped = find_orbit(stepper_, forces_, begin, {.keep_going = [] { return false; }});
  EXPECT_EQ(stopped.status, Status::interrupted);
  EXPECT_EQ(stopped.turns, 0);
  EXPECT_EQ(stopped.state.rotor.y, begin.rotor.y);
  EXPECT_TRUE(stopped.bearings.empty());
}

/// A motion that would close the film is scaled to leave half the film where it shrinks most.
TEST_F(OrbitSearch, LeavesHalfOfTheFilm) {
  const MachineState rest = stepper_.at_rest({rest_}, load_);
  MachineState moved = rest;
  add_motion(stepper_, Eigen::Vector2cd(1e-3, std::complex<double>(0.0, -1e-3)), moved);
  const Matrix& before = rest.bearings.front().film.thickness;
  const Matrix& after = moved.bearings.front().film.thickness;
  EXPECT_NEAR(after.cwiseQuotient(before).minCoeff(), 0.5, 1e-9);
  const double part = (moved.rotor.y - rest.rotor.y)[0] / 1e-3;
  EXPECT_NEAR(moved.rotor.v[1], part * 1e-3 * std::abs(speed_), 1e-12);  // d/dt Re(-i e^{i nu t}) = nu at t = 0
  EXPECT_EQ(moved.bearings.front().position, Eigen::Vector2d(moved.rotor.y));
}

}  // namespace
}  // namespace bumpfoil
