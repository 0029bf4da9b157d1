#include "origin/former_cycle.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/origin/former_model.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

Case former_case() {
  Case input = case_with_given_constants();
  input.bump_foil.model = BumpFoilModel::former;
  input.settings.get<CycleSettings>().steps = 20;
  return input;
}

TEST(FormerCycle, UnloadsOnTheCurveOfLoading) {
  const CycleResult result = run_cycles(former_case());
  ASSERT_EQ(result.cycles.size(), 4U);
  for (const Cycle& cycle : result.cycles) {
    ASSERT_TRUE(cycle.converged());
    for (std::size_t k = 0; k <= 20; ++k) {
      EXPECT_EQ(cycle.increments[k].force_direct, cycle.increments[40 - k].force_direct);
      EXPECT_EQ(cycle.increments[k].branch, Branch::loading);
    }
    EXPECT_EQ(cycle.increments[21].branch, Branch::unloading);
    EXPECT_EQ(cycle.substeps, 0);
    EXPECT_LT(cycle.max_residual, 1e-9);
    ASSERT_TRUE(cycle.loop_energy && cycle.turning_point);
    EXPECT_NEAR(*cycle.loop_energy, 0.0, 1e-15);  // round-off of about 15 mJ
    EXPECT_EQ(cycle.turning_point->tangent.loading, cycle.turning_point->tangent.unloading);
    EXPECT_GT(cycle.turning_point->tangent.loading.value(), 0.0);
    for (const Increment& increment : cycle.increments) EXPECT_EQ(increment.dissipated_energy, 0.0);
  }
}

TEST(FormerCycle, RecordsWhatTheSolverFinds) {
  Case input = former_case();
  input.settings.get<CycleSettings>().directions = {0.7};
  const Cycle cycle = run_cycles(input).cycles.front();
  const FullIncrement turning = turning_increment(cycle);
  const FormerModel model = make_former_model(input);
  const FormerSolution solution = FormerSolver(model).solve({turning.x, turning.y});
  const Vector gap = former_crest_gaps(model, {turning.x, turning.y});
  for (Eigen::Index i = 0; i < 26; ++i) {
    EXPECT_EQ(turning.crest_u[i], solution.state.x[4 * i]);
    EXPECT_EQ(turning.crest_v[i], solution.state.x[4 * i + 1]);
    EXPECT_EQ(turning.foot_u[i], solution.state.x[4 * i + 2]);
    EXPECT_EQ(turning.top_displacement[i], gap[i] < 0.0 ? -gap[i] : 0.0);
    EXPECT_EQ(turning.top_bump.normal_force[i], solution.state.normal_force[2 * i]);
    EXPECT_EQ(turning.journal_top.normal_force[i], turning.top_bump.normal_force[i]);
    EXPECT_EQ(turning.journal_top.friction_force[i], 0.0);
    EXPECT_EQ(turning.bump_sleeve.friction_force[i], solution.state.friction_force[2 * i + 1]);
    EXPECT_EQ(turning.bump_sleeve.gap[i], 0.0);
    if (gap[i] < 0.0) {
      EXPECT_EQ(turning.top_bump.gap[i], 0.0);
    } else {
      EXPECT_EQ(turning.top_bump.gap[i], gap[i] + turning.crest_v[i]);
      EXPECT_EQ(turning.journal_top.mode[static_cast<std::size_t>(i)], ContactMode::open);
    }
  }
  const Eigen::Vector2d force = former_journal_force(model, solution.state);
  EXPECT_EQ(turning.force_x, force.x());
  EXPECT_EQ(turning.force_y, force.y());
  EXPECT_NEAR(turning.elastic_energy, 0.5 * solution.state.x.dot(model.structure.K.multiply(solution.state.x)), 1e-15);
}

TEST(FormerCycle, TouchesWhereTheFirstCrestIsReached) {
  Case input = former_case();
  input.settings.get<CycleSettings>().directions = {0.0};
  const Cycle cycle = run_cycles(input).cycles.front();
  ASSERT_TRUE(cycle.first_contact);
  const FormerModel model = make_former_model(input);
  EXPECT_GE(former_crest_gaps(model, {*cycle.first_contact - 1e-12, 0.0}).minCoeff(), 0.0);
  EXPECT_LT(former_crest_gaps(model, {*cycle.first_contact + 1e-12, 0.0}).minCoeff(), 0.0);
}

TEST(FormerCycle, StopsWhenAsked) {
  int calls = 0;
  const CycleResult result = run_cycles(former_case(), [&](double) { return ++calls < 5; });
  ASSERT_EQ(result.cycles.size(), 1U);
  EXPECT_EQ(result.cycles.front().increments.size(), 5U);
  EXPECT_FALSE(result.converged());
}

}  // namespace
}  // namespace bumpfoil
