#include "bumpfoil/ensemble/running_sample.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/ensemble/sample.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

TEST(RunningSample, ComesToTheStatesOfItsCase) {
  const Case input = test_support::running_ensemble_case(1);
  const EquilibriumResult result = run_running_sample(sampled_case(input, draw_sample(input, 0))).value();
  ASSERT_EQ(result.states.size(), 2U);
  EXPECT_TRUE(result.converged());
  EXPECT_EQ(result.states[1].asked, planned_states(*input.equilibrium, Status::not_reached)[1].asked);
}

TEST(RunningSample, HasLimitsWhereTheyAreAskedFor) {
  Case input = test_support::running_ensemble_case(1);
  input.film.h_lift_off = 8e-6;
  input.top_foil.formed_radius = {FormedTo::seated};  // states last
  const Case sampled = sampled_case(input, draw_sample(input, 0));
  EXPECT_TRUE(run_running_sample(sampled).value().limits.empty());
  const EquilibriumResult result = run_running_sample(sampled, {}, true).value();
  ASSERT_EQ(result.limits.size(), 3U);
  EXPECT_GT(result.states[1].lift_off_speed->value, result.states[0].lift_off_speed->value);
}

TEST(RunningSample, IsNothingWhereWhatWasDrawnMakesNoBearing) {
  Case sampled = test_support::running_ensemble_case(1);
  sampled.bump_foil.thickness = -0.1e-3;
  EXPECT_FALSE(run_running_sample(sampled));
}

TEST(RunningSample, OfARotorIsItsCommandOnTheCaseThatWasDrawn) {
  const Case input = test_support::rotor_ensemble_case(2);
  const Case sampled = sampled_case(input, draw_sample(input, 1));
  const StabilityResult result = run_rotor_sample(sampled).value();
  for (const SpeedPoint& point : result.map.points) ASSERT_EQ(point.status, Status::converged);
  ASSERT_FALSE(result.map.onsets.empty());
  EXPECT_EQ(result.map.onsets.front().onset.speed, run_stability(sampled).map.onsets.front().onset.speed);
  EXPECT_NE(result.map.onsets.front().onset.speed, run_stability(input).map.onsets.front().onset.speed);
  const StabilityResult stopped = run_rotor_sample(sampled, [](double) { return false; }).value();
  EXPECT_EQ(stopped.map.points[0].status, Status::interrupted);
  Case none = sampled;
  none.bump_foil.thickness = -0.1e-3;
  EXPECT_FALSE(run_rotor_sample(none));
}

TEST(RunningSample, RespondsToUnbalanceAsItsCommandDoes) {
  const Case input = test_support::unbalance_ensemble_case(2);
  const Case sampled = sampled_case(input, draw_sample(input, 1));
  const UnbalanceResult result = run_unbalance_sample(sampled).value();
  ASSERT_TRUE(result.points[2].stuck.has_value());
  EXPECT_EQ(*result.points[2].stuck, *run_unbalance(sampled).points[2].stuck);
  EXPECT_NE(*result.points[2].stuck, *run_unbalance(input).points[2].stuck);
  const UnbalanceResult stopped = run_unbalance_sample(sampled, [](double) { return false; }).value();
  EXPECT_EQ(stopped.points[0].status, Status::interrupted);
  Case none = sampled;
  none.bump_foil.thickness = -0.1e-3;
  EXPECT_FALSE(run_unbalance_sample(none));
}

TEST(RunningSample, CanBeStopped) {
  const Case input = test_support::running_ensemble_case(1);
  const EquilibriumResult result =
      run_running_sample(sampled_case(input, draw_sample(input, 0)), [](double) { return false; }).value();
  EXPECT_EQ(result.states[0].report.status, Status::interrupted);
}

}  // namespace
}  // namespace bumpfoil
