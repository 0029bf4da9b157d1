#include "bumpfoil/experiments/cycle/measured_loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/experiments/reference_case.hpp"
#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

using Points = std::vector<LoadingCurve::Point>;

TEST(MeasuredLoop, OfATriangleHasTheQuantitiesOfTheClosedForm) {
  // Up to 100 N at 10 um, down to 0 N at 2 um: the straight line to its start closes it.
  const Cycle cycle =
      measured_cycle({{0.0, 0.0}, {4e-6, 40.0}, {10e-6, 100.0}, {6e-6, 50.0}, {2e-6, 0.0}}, {5.0, 200.0});
  EXPECT_EQ(cycle.course, Course::one_sided);
  EXPECT_EQ(cycle.steps, 2);
  EXPECT_DOUBLE_EQ(cycle.amplitude, 10e-6);
  EXPECT_DOUBLE_EQ(cycle.turning_point->max_force, 100.0);
  EXPECT_NEAR(cycle.loop_energy.value(), 1e-4, 1e-18);  // half of 2 um times 100 N
  EXPECT_NEAR(cycle.take_up.value(), 0.1e-6, 1e-18);    // where the force exceeds 1 N
  EXPECT_NEAR(cycle.loaded_stiffness.value(), 1e7, 1e-6);
  EXPECT_NEAR(cycle.secant_stiffness.value(), 1e7, 1e-6);
  EXPECT_NEAR(cycle.loss_factor.value(), 1e-4 / (std::numbers::pi * 1e7 * std::pow(4.95e-6, 2)), 1e-12);
  EXPECT_FALSE(cycle.specific_damping_capacity);
  EXPECT_NEAR(cycle.clearances[0].displacement.value(), 0.5e-6, 1e-18);
  EXPECT_FALSE(cycle.clearances[1].displacement);
  ASSERT_EQ(cycle.increments.size(), 5U);
  EXPECT_EQ(cycle.increments[2].branch, Branch::loading);
  EXPECT_EQ(cycle.increments[3].branch, Branch::unloading);
}

TEST(MeasuredLoop, ToBothSidesIsFullyReversed) {
  // A parametric ellipse, F = K x + C y: the loop energy is pi X C.
  constexpr double amplitude = 20e-6, stiffness = 5e6, across = 30.0;
  constexpr int count = 4000;
  Points points;
  for (int i = 0; i <= 5 * count / 4; ++i) {
    const double t = 2.0 * std::numbers::pi * i / count;
    // From the middle to the right end, then one turn.
    if (i < count / 4) {
      points.push_back({amplitude * std::sin(t), stiffness * amplitude * std::sin(t)});
    } else {
      points.push_back({amplitude * std::sin(t), stiffness * amplitude * std::sin(t) + across * std::cos(t)});
    }
  }
  const Cycle cycle = measured_cycle(points, {});
  EXPECT_EQ(cycle.course, Course::fully_reversed);
  EXPECT_NEAR(cycle.loaded_stiffness.value(), stiffness, 1e-3);
  // The closing line retraces the path from the start. The area of a polygon with n corners is 2/3 (pi / n)^2 less than
  // that of the ellipse.
  const double energy = std::numbers::pi * amplitude * across;
  EXPECT_NEAR(cycle.loop_energy.value(), energy, 1e-6 * energy);
  EXPECT_EQ(cycle.increments.back().branch, Branch::loading);
  EXPECT_FALSE(cycle.take_up);
}

TEST(MeasuredLoop, OfComputedPointsHasTheirQuantities) {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.0};
  cycle.steps = 40;
  const Cycle computed = run_cycles(input).cycles.front();
  Points points;
  for (const Increment& increment : computed.increments) {
    points.push_back({increment.displacement, increment.force_direct});
  }
  const Cycle measured = measured_cycle(points, {5.0});
  EXPECT_NEAR(measured.loop_energy.value(), computed.loop_energy.value(), 1e-12 * *computed.loop_energy);
  EXPECT_EQ(measured.turning_point->max_force, computed.turning_point->max_force);
  EXPECT_EQ(measured.steps, computed.steps);
  // The displacement of first contact is known for the computed loop, but not for points: a step of 2 um of 45.
  EXPECT_NEAR(measured.loaded_stiffness.value(), computed.loaded_stiffness.value(), 0.02 * *computed.loaded_stiffness);
  EXPECT_NEAR(measured.clearances[0].displacement.value(), computed.clearances[0].displacement.value(), 2e-6);
}

/// A rig recording of several cycles: straight paths between displacements, 100 points each, with the force of a loop
/// of half width `width`. The displacements have noise of +-1 % of 10 um.
Points recorded(const std::vector<double>& turns, double noise = 0.1e-6) {
  constexpr double stiffness = 5e6, width = 4.0;
  Points points;
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double way = turns[i] - turns[i - 1];
    for (int k = 0; k < 100; ++k) {
      const double displacement = turns[i - 1] + way * k / 100.0;
      // Friction reverses over a fifth of the path.
      const double friction = i == 1 ? 0.0 : width * (way > 0 ? 1.0 : -1.0) * std::min(1.0, k / 10.0 - 1.0);
      points.push_back({displacement + (k % 2 == 0 ? noise : -noise), stiffness * displacement + friction});
    }
  }
  const bool up = turns.back() > turns[turns.size() - 2];
  points.push_back({turns.back(), stiffness * turns.back() + (up ? width : -width)});
  return points;
}

struct Recording {
  std::vector<double> turns;  ///< um
  std::size_t found;
  double first;  ///< of the last whole cycle, um
  double last;
  bool rest;
};

TEST(MeasuredLoop, OfSeveralCyclesTheLastWholeOneIsTaken) {
  const std::vector<Recording> recordings{{{0, 10, 0}, 1, 0, 0, false},
                                          {{0, 10, 2}, 1, 0, 2, false},
                                          {{0, 10, 0, 10, 0, 10, 0}, 3, 0, 0, false},
                                          {{0, 10, 0, 10, 0, 10}, 2, 0, 0, true},      // half a cycle more
                                          {{0, 10, 0, 10, 0, 10, 5}, 2, 0, 0, true},   // not yet back
                                          {{0, 10, 1, 11, 2, 12, 3}, 3, 2, 3, false},  // drift
                                          {{0, 4, 0, 7, 0, 10, 0}, 3, 0, 0, false},    // growing
                                          {{5, 10, 0, 10, 0}, 2, 0, 0, false},         // starts on a rising path
                                          {{5, 0, 10, 0}, 1, 0, 0, false},             // starts on a falling path
                                          {{0, 10, -10, 10}, 1, 0, 10, false},         // both sides, from the middle
                                          {{0, 10, -10, 0}, 1, 0, 0, false},
                                          {{0, 10, -10, 10, 0}, 1, 0, 10, true},
                                          {{0, 10, -10, 10, -10, 10, -10, 0}, 3, -10, -10, true},
                                          {{0, -10, 10, -10, 10, -10}, 2, -10, -10, false},
                                          {{-10, 10, -10}, 1, -10, -10, false}};
  for (const double noise : {0.0, 0.1e-6}) {
    for (const Recording& recording : recordings) {
      std::vector<double> turns = recording.turns;
      for (double& turn : turns) turn *= 1e-6;
      const auto cycle = last_cycle(recorded(turns, noise));
      ASSERT_TRUE(cycle) << ::testing::PrintToString(recording.turns);
      EXPECT_EQ(cycle->found, recording.found) << ::testing::PrintToString(recording.turns);
      EXPECT_EQ(cycle->rest, recording.rest) << ::testing::PrintToString(recording.turns);
      EXPECT_NEAR(cycle->points.front().displacement, 1e-6 * recording.first, 0.3e-6)
          << ::testing::PrintToString(recording.turns);
      EXPECT_NEAR(cycle->points.back().displacement, 1e-6 * recording.last, 0.3e-6)
          << ::testing::PrintToString(recording.turns);
    }
  }
}

TEST(MeasuredLoop, OfSeveralCyclesHasTheEnergyOfOne) {
  const auto energy = [](const std::vector<double>& turns) {
    return measured_cycle(last_cycle(recorded(turns, 0.0))->points, {}).loop_energy.value();
  };
  // Two paths of 10 um at 4 N, minus a fifth: friction reverses linearly over a fifth of the path.
  const double two = energy({0, 10e-6, 0, 10e-6, 0});
  EXPECT_NEAR(two, 0.8 * 2 * 4.0 * 10e-6, 1e-9 * two);
  EXPECT_NEAR(energy({0, 10e-6, 0, 10e-6, 0, 10e-6, 0}), two, 1e-9 * two);
  const double across = energy({0, 10e-6, -10e-6, 10e-6, -10e-6, 0});
  EXPECT_NEAR(across, 2 * two, 1e-9 * two);
  EXPECT_NEAR(energy({-10e-6, 10e-6, -10e-6, 10e-6, -10e-6}), across, 1e-9 * two);
}

TEST(MeasuredLoop, SaysHowFarItIsFromClosing) {
  EXPECT_FALSE(last_cycle(recorded({0, 10e-6, 0, 10e-6, 0}, 0.0))->gap);
  const auto gap = last_cycle(recorded({0, 10e-6, 0, 11e-6, 1e-6}, 0.0))->gap;
  ASSERT_TRUE(gap);
  EXPECT_NEAR(gap->displacement, 1e-6, 1e-12);
  EXPECT_NEAR(gap->force, 5.0, 1e-6);
  EXPECT_FALSE(last_cycle(recorded({0, 10e-6, -10e-6, 10e-6}, 0.0))->gap);
}

TEST(MeasuredLoop, GoesThereAndBack) {
  EXPECT_TRUE(last_cycle({{0.0, 0.0}, {1e-6, 1.0}, {0.0, 0.0}}));
  EXPECT_FALSE(last_cycle({}));
  EXPECT_FALSE(last_cycle({{0.0, 0.0}, {1e-6, 1.0}}));
  EXPECT_FALSE(last_cycle({{0.0, 0.0}, {1e-6, 1.0}, {0.95e-6, 0.9}, {0.98e-6, 0.9}}));  // noise is not a reversal
  EXPECT_FALSE(last_cycle({{1e-6, 1.0}, {0.0, 0.0}, {0.5e-6, 1.0}}));
  EXPECT_FALSE(last_cycle({{-2e-6, 1.0}, {-1e-6, 0.0}, {-2e-6, 1.0}}));
}

}  // namespace
}  // namespace bumpfoil
