#include "bumpfoil/motion/speed_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace bumpfoil {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Follows a speed program as a rotor does.
struct Turning {
  explicit Turning(SpeedProgram speeds, int steps, double longest = no_limit)
      : program(std::move(speeds)), steps_per_turn(steps), longest_step(longest) {
    state.speed = program.start();
  }
  /// @return nothing at the end
  std::optional<TimeStep> step() {
    const std::optional<TimeStep> next = program.next_step(state, steps_per_turn, longest_step);
    if (!next) return next;
    state.angle += 0.5 * (state.speed + next->speed) * next->dt;
    state.speed = next->speed;
    state.time += next->dt;
    return next;
  }

  SpeedProgram program;
  int steps_per_turn;
  double longest_step;
  MachineState state;
};

TEST(SpeedProgram, TakesEqualAnglesAndEndsTurnsWithAStep) {
  for (const double sense : {1.0, -1.0}) {
    Turning rotor(SpeedProgram({{sense * 2000.0, sense * 500.0, 0.1}}), 40);
    for (int turn = 1; turn <= 3; ++turn) {
      for (int i = 0; i < 40; ++i) {
        const double before = rotor.state.angle;
        rotor.step();
        EXPECT_NEAR(std::abs(rotor.state.angle - before), full_turn / 40.0, 1e-12);
      }
      EXPECT_EQ(whole_turns(rotor.state.angle), turn);
      EXPECT_NEAR(std::abs(rotor.state.angle), turn * full_turn, 1e-11);
    }
    // Constant acceleration.
    EXPECT_NEAR(rotor.state.speed, sense * (2000.0 - 15000.0 * rotor.state.time), 1e-9);
    while (rotor.step()) continue;
    EXPECT_NEAR(rotor.state.time, 0.1, 1e-15);
    EXPECT_EQ(rotor.state.speed, sense * 500.0);
    EXPECT_NEAR(rotor.state.angle, sense * 125.0, 1e-10);  // mean speed times time
  }
}

TEST(SpeedProgram, BeginsAtRestWithStepsOfSomeTime) {
  constexpr double longest = 1e-3;
  Turning rotor(SpeedProgram({{0.0, 300.0, 0.5}}), 50, longest);
  long steps = 0;
  for (; whole_turns(rotor.state.angle) < 1; ++steps) {
    EXPECT_LE(rotor.step().value().dt, (1.0 + 1e-12) * longest);
    ASSERT_LT(steps, 1000);
  }
  EXPECT_NEAR(rotor.state.angle, full_turn, 1e-10);
  EXPECT_GT(steps, 100);  // sqrt(2 angle / acceleration) = 0.145 s
  while (rotor.step()) continue;
  EXPECT_EQ(rotor.state.speed, 300.0);
}

TEST(SpeedProgram, GoesFromRampToRamp) {
  Turning rotor(SpeedProgram({{100.0, 200.0, 0.33}, {200.0, 200.0, 0.1}, {200.0, 0.0, 0.21}}), 17, 0.02);
  EXPECT_EQ(rotor.program.highest(), 200.0);
  double shortest = no_limit;
  bool has_met_corner = false;
  while (const auto step = rotor.step()) {
    shortest = std::min(shortest, step->dt);
    has_met_corner |= std::abs(rotor.state.time - 0.33) < 1e-12 && rotor.state.speed == 200.0;
  }
  EXPECT_TRUE(has_met_corner);
  EXPECT_GT(shortest, 0.4 * full_turn / 17.0 / 200.0);  // no tiny steps
  EXPECT_EQ(rotor.state.speed, 0.0);
  EXPECT_NEAR(rotor.state.angle, 150.0 * 0.33 + 20.0 + 21.0, 1e-9);
}

TEST(SpeedProgram, StandsStill) {
  Turning rotor(SpeedProgram({{0.0, 0.0, 0.1}}), 17, 0.02);
  int steps = 0;
  while (rotor.step()) ++steps;
  EXPECT_EQ(steps, 5);
  EXPECT_EQ(whole_turns(rotor.state.angle), 0);
}

}  // namespace
}  // namespace bumpfoil
