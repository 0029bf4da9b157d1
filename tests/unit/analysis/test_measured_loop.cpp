#include "bumpfoil/analysis/measured_loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

using Points = std::vector<LoadingCurve::Point>;

TEST(MeasuredLoop, OfATriangleHasTheQuantitiesOfTheClosedForm) {
  // Up to 100 N at 10 um, down to 0 N at 2 um: the straight line to its start closes it.
  const Cycle cycle =
      measured_cycle({{0.0, 0.0}, {4e-6, 40.0}, {10e-6, 100.0}, {6e-6, 50.0}, {2e-6, 0.0}}, {5.0, 200.0});
  EXPECT_EQ(cycle.course, Course::push);
  EXPECT_EQ(cycle.steps, 2);
  EXPECT_DOUBLE_EQ(cycle.amplitude, 10e-6);
  EXPECT_DOUBLE_EQ(cycle.turning_point->max_force, 100.0);
  EXPECT_NEAR(cycle.loop_energy.value(), 1e-4, 1e-18);  // half of 2 um times 100 N
  EXPECT_NEAR(cycle.take_up.value(), 0.1e-6, 1e-18);    // where 1 N is passed
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

TEST(MeasuredLoop, ToBothSidesIsASwing) {
  // An ellipse F = K x + C y, by its parameter: the loop energy is pi X C.
  constexpr double amplitude = 20e-6, stiffness = 5e6, across = 30.0;
  constexpr int count = 4000;
  Points points;
  for (int i = 0; i <= 5 * count / 4; ++i) {
    const double t = 2.0 * std::numbers::pi * i / count;
    // From the middle to the right end, then once round.
    if (i < count / 4) {
      points.push_back({amplitude * std::sin(t), stiffness * amplitude * std::sin(t)});
    } else {
      points.push_back({amplitude * std::sin(t), stiffness * amplitude * std::sin(t) + across * std::cos(t)});
    }
  }
  const Cycle cycle = measured_cycle(points, {});
  EXPECT_EQ(cycle.course, Course::swing);
  EXPECT_NEAR(cycle.loaded_stiffness.value(), stiffness, 1e-3);
  // The line to the start goes back over the way from it. A polygon of n corners lacks 2/3 (pi / n)^2 of the ellipse.
  const double energy = std::numbers::pi * amplitude * across;
  EXPECT_NEAR(cycle.loop_energy.value(), energy, 1e-6 * energy);
  EXPECT_EQ(cycle.increments.back().branch, Branch::loading);
  EXPECT_FALSE(cycle.take_up);
}

TEST(MeasuredLoop, OfComputedPointsHasTheirQuantities) {
  Case input = reference_case();
  input.cycle.directions = {0.0};
  input.cycle.steps = 40;
  const Cycle computed = run_cycles(input).cycles.front();
  Points points;
  for (const Increment& increment : computed.increments) {
    points.push_back({increment.displacement, increment.force_direct});
  }
  const Cycle measured = measured_cycle(points, {5.0});
  EXPECT_NEAR(measured.loop_energy.value(), computed.loop_energy.value(), 1e-12 * *computed.loop_energy);
  EXPECT_EQ(measured.turning_point->max_force, computed.turning_point->max_force);
  EXPECT_EQ(measured.steps, computed.steps);
  // Before the first touch the computed one knows where the force begins, points do not: a step of 2 um of 45.
  EXPECT_NEAR(measured.loaded_stiffness.value(), computed.loaded_stiffness.value(), 0.02 * *computed.loaded_stiffness);
  EXPECT_NEAR(measured.clearances[0].displacement.value(), computed.clearance_5N.value(), 2e-6);
}

TEST(MeasuredLoop, GoesThereAndBack) {
  EXPECT_TRUE(turns_round({{0.0, 0.0}, {1e-6, 1.0}, {0.0, 0.0}}));
  EXPECT_FALSE(turns_round({}));
  EXPECT_FALSE(turns_round({{0.0, 0.0}, {1e-6, 1.0}}));
  EXPECT_FALSE(turns_round({{1e-6, 1.0}, {0.0, 0.0}, {0.5e-6, 1.0}}));
  EXPECT_FALSE(turns_round({{-2e-6, 1.0}, {-1e-6, 0.0}, {-2e-6, 1.0}}));
}

}  // namespace
}  // namespace bumpfoil
