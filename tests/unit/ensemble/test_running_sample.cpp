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

TEST(RunningSample, CanBeStopped) {
  const Case input = test_support::running_ensemble_case(1);
  const EquilibriumResult result =
      run_running_sample(sampled_case(input, draw_sample(input, 0)), [](double) { return false; }).value();
  EXPECT_EQ(result.states[0].report.status, Status::interrupted);
}

}  // namespace
}  // namespace bumpfoil
