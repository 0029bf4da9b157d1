#include "bumpfoil/analysis/cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "bumpfoil/model/geometry.hpp"
#include "support/bearing_cases.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

constexpr double pi = std::numbers::pi;

Case short_case(int steps = 10) {
  Case input = case_with_given_constants();
  input.cycle.steps = steps;
  return input;
}

TEST(Cycle, GoesThereAndBackInEqualIncrements) {
  const Cycle cycle = run_single_cycle(short_case(), 2.0);
  EXPECT_EQ(cycle.direction, 2.0);
  EXPECT_EQ(cycle.amplitude, 79.5e-6);
  EXPECT_EQ(cycle.steps, 10);
  ASSERT_EQ(cycle.increments.size(), 21U);
  for (std::size_t k = 0; k <= 20; ++k) {
    const Increment& increment = cycle.increments[k];
    EXPECT_EQ(increment.index, static_cast<int>(k));
    EXPECT_EQ(increment.branch, k <= 10 ? Branch::loading : Branch::unloading);
    EXPECT_NEAR(increment.displacement, 7.95e-6 * static_cast<double>(k <= 10 ? k : 20 - k), 1e-19);
    EXPECT_NEAR(increment.x, increment.displacement * std::cos(2.0), 1e-19);
    EXPECT_NEAR(increment.y, increment.displacement * std::sin(2.0), 1e-19);
  }
  EXPECT_EQ(cycle.increments[10].displacement, 79.5e-6);  // not a rounding beside it
  EXPECT_EQ(cycle.increments[20].displacement, 0.0);
}

TEST(Cycle, FieldsOfAnIncrementBelongTogether) {
  const Cycle cycle = run_single_cycle(short_case(), 1.0);
  const Case input = short_case();
  const Eigen::Matrix2Xd normals = outward_normals(polar_angles(input.bearing, crest_angles(input)));
  for (const Increment& increment : cycle.increments) {
    const Eigen::Vector2d force = journal_force(normals, increment.journal_top.normal_force);
    const double size = 1e-12 * (1.0 + force.norm());
    EXPECT_NEAR(increment.force_x, force.x(), size);
    EXPECT_NEAR(increment.force_y, force.y(), size);
    EXPECT_NEAR(increment.force_direct, force.x() * std::cos(1.0) + force.y() * std::sin(1.0), size);
    EXPECT_NEAR(increment.force_cross, -force.x() * std::sin(1.0) + force.y() * std::cos(1.0), size);
    const Vector r = journal_gaps(input.bearing.radial_clearance, normals, {increment.x, increment.y});
    for (Eigen::Index i = 0; i < 26; ++i) {
      const auto entry = static_cast<std::size_t>(i);
      const double g_r = r[i] + increment.top_displacement[i];
      const double g_t = increment.crest_v[i] - increment.top_displacement[i];
      const double g_b = -increment.foot_v[i];
      EXPECT_NEAR(increment.journal_top.gap[i], g_r, 1e-13);
      EXPECT_NEAR(increment.top_bump.gap[i], g_t, 1e-13);
      EXPECT_NEAR(increment.bump_sleeve.gap[i], g_b, 1e-13);
      for (const InterfaceFields* fields : {&increment.journal_top, &increment.top_bump, &increment.bump_sleeve}) {
        const bool open = fields->mode[entry] == ContactMode::open;
        EXPECT_GE(fields->gap[i], 0.0);
        EXPECT_GE(fields->normal_force[i], 0.0);
        EXPECT_EQ(fields->normal_force[i] == 0.0, open);
        EXPECT_LE(std::abs(fields->friction_force[i]), 0.1 * fields->normal_force[i] + 1e-9);
      }
      EXPECT_EQ(increment.journal_top.friction_force[i], 0.0);
    }
  }
}

TEST(Cycle, SlippingFrictionOpposesTheMotionSinceTheLastIncrement) {
  const Cycle cycle = run_single_cycle(short_case(20), 0.0);
  int slipping = 0;
  for (std::size_t k = 1; k < cycle.increments.size(); ++k) {
    const Increment& now = cycle.increments[k];
    const Vector slip = now.crest_u - cycle.increments[k - 1].crest_u;
    for (Eigen::Index i = 0; i < 26; ++i) {
      const ContactMode mode = now.top_bump.mode[static_cast<std::size_t>(i)];
      if (mode != ContactMode::slip_forward && mode != ContactMode::slip_backward) continue;
      ++slipping;
      const double sign = mode == ContactMode::slip_forward ? 1.0 : -1.0;
      EXPECT_GE(sign * slip[i], -1e-13);
      EXPECT_NEAR(now.top_bump.friction_force[i], -sign * 0.1 * now.top_bump.normal_force[i], 1e-9);
    }
  }
  EXPECT_GT(slipping, 50);
}

TEST(Cycle, QuantitiesFollowFromTheIncrements) {
  const Cycle cycle = run_single_cycle(short_case(), pi);
  ASSERT_TRUE(cycle.converged);
  ASSERT_TRUE(cycle.turning_point && cycle.loop_energy && cycle.loss_factor);
  const Increment& turning = cycle.at_turning_point();
  EXPECT_EQ(turning.index, 10);
  EXPECT_EQ(cycle.turning_point->max_force, turning.force_direct);
  EXPECT_EQ(cycle.turning_point->cross_force, turning.force_cross);
  EXPECT_EQ(cycle.turning_point->elastic_energy, turning.elastic_energy);
  EXPECT_DOUBLE_EQ(cycle.turning_point->secant_stiffness, turning.force_direct / 79.5e-6);
  double work = 0.0;
  for (std::size_t k = 1; k < cycle.increments.size(); ++k) {
    const Increment& a = cycle.increments[k - 1];
    const Increment& b = cycle.increments[k];
    work += 0.5 * (a.force_direct + b.force_direct) * (b.displacement - a.displacement);
    EXPECT_NEAR(b.work, work, 1e-15);
  }
  EXPECT_NEAR(*cycle.loop_energy, work, 1e-15);
  EXPECT_DOUBLE_EQ(
      *cycle.loss_factor,
      *cycle.loop_energy / (2.0 * pi * (turning.elastic_energy - cycle.increments.front().elastic_energy)));
  EXPECT_LT(*cycle.first_contact, *cycle.clearance_5N);
  EXPECT_LT(*cycle.clearance_5N, *cycle.clearance_10N);
  int iterations = 0;
  for (const Increment& increment : cycle.increments) iterations += increment.solve.iterations;
  EXPECT_EQ(cycle.total().iterations, iterations);
  EXPECT_TRUE(cycle.total().converged);
  EXPECT_GT(cycle.wall_time, 0.0);
}

TEST(Cycle, AnUnknownResidualIsNotTakenForASmallOne) {
  Cycle cycle;
  cycle.increments.resize(3);
  cycle.increments[0].residuals.equilibrium = 1e-12;
  cycle.increments[1].residuals.equilibrium = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(cycle.max_residual()));
  cycle.increments[1].residuals.equilibrium = 3e-12;
  EXPECT_EQ(cycle.max_residual(), 3e-12);
}

TEST(Cycle, PushThatTouchesNothingHasNoLoopAndNoLossFactor) {
  Case input = short_case();
  input.cycle.amplitude = 20e-6;
  const Cycle cycle = run_single_cycle(input, 0.0);
  EXPECT_TRUE(cycle.converged);
  EXPECT_EQ(cycle.turning_point->max_force, 0.0);
  EXPECT_EQ(cycle.turning_point->tangent.loading, 0.0);
  EXPECT_EQ(cycle.loop_energy, 0.0);
  EXPECT_EQ(cycle.loss_factor, std::nullopt);
  EXPECT_EQ(cycle.clearance_5N, std::nullopt);
}

TEST(RunCycles, StartsEveryDirectionAnew) {
  const Case input = short_case();
  const CycleResult all = run_cycles(input);
  ASSERT_EQ(all.cycles.size(), 4U);
  EXPECT_EQ(all.solver, SolverName::newton);
  EXPECT_TRUE(all.converged());
  for (std::size_t i = 0; i < 4; ++i) {
    const Cycle alone = run_single_cycle(input, input.cycle.directions[i]);
    EXPECT_EQ(alone.turning_point->max_force, all.cycles[i].turning_point->max_force);
    EXPECT_EQ(*alone.loop_energy, *all.cycles[i].loop_energy);
  }
}

TEST(RunCycles, GivesTheSameNumbersEveryTime) {
  const CycleResult a = run_cycles(short_case());
  const CycleResult b = run_cycles(short_case());
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < a.cycles[i].increments.size(); ++k) {
      EXPECT_EQ(a.cycles[i].increments[k].force_direct, b.cycles[i].increments[k].force_direct);
      EXPECT_EQ(a.cycles[i].increments[k].top_bump.friction_force, b.cycles[i].increments[k].top_bump.friction_force);
    }
  }
}

TEST(RunCycles, ReportsProgressThatRisesToOne) {
  std::vector<double> seen;
  (void)run_cycles(short_case(), [&](double done) {
    seen.push_back(done);
    return true;
  });
  ASSERT_EQ(seen.size(), 84U);
  for (std::size_t i = 1; i < seen.size(); ++i) EXPECT_GT(seen[i], seen[i - 1]);
  EXPECT_DOUBLE_EQ(seen.back(), 1.0);
}

TEST(RunCycles, StopsWhenAskedAndKeepsWhatIsThere) {
  int calls = 0;
  // After the turning point of the second direction: increments 0..20 of the first, 0..12 of the second.
  const CycleResult result = run_cycles(short_case(), [&](double) { return ++calls < 34; });
  ASSERT_EQ(result.cycles.size(), 2U);
  EXPECT_TRUE(result.cycles[0].converged);
  const Cycle& stopped = result.cycles[1];
  EXPECT_FALSE(stopped.converged);
  EXPECT_FALSE(result.converged());
  EXPECT_EQ(stopped.increments.size(), 13U);
  EXPECT_TRUE(stopped.turning_point.has_value());
  EXPECT_EQ(stopped.loop_energy, std::nullopt);
  EXPECT_EQ(stopped.loss_factor, std::nullopt);
}

TEST(RunCycles, StoppedBeforeTheTurningPointHasNone) {
  const CycleResult result = run_cycles(short_case(), [](double) { return false; });
  ASSERT_EQ(result.cycles.size(), 1U);
  EXPECT_EQ(result.cycles[0].increments.size(), 1U);
  EXPECT_EQ(result.cycles[0].turning_point, std::nullopt);
  EXPECT_FALSE(result.converged());
}

TEST(RunCycles, OneStepPerBranchIsEnoughToTurn) {
  const Cycle cycle = run_single_cycle(short_case(1), 0.0);
  EXPECT_TRUE(cycle.converged);
  ASSERT_EQ(cycle.increments.size(), 3U);
  EXPECT_GT(cycle.turning_point->max_force, 100.0);
  EXPECT_EQ(*cycle.loop_energy, 0.0);  // both trapezia are the same triangle
}

}  // namespace
}  // namespace bumpfoil
