#include "bumpfoil/ensemble/running_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/motion/response.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

TEST(RunningSample, ComesToTheStatesOfItsCase) {
  const Case input = test_support::running_ensemble_case(1);
  const EquilibriumResult result = run_running_sample(sampled_case(input, draw_sample(input, 0))).value();
  ASSERT_EQ(result.states.size(), 2U);
  EXPECT_TRUE(result.converged());
  EXPECT_EQ(result.states[1].requested, planned_states(*input.equilibrium, Status::not_reached)[1].requested);
}

TEST(RunningSample, HasLimitsWhereTheyAreAskedFor) {
  Case input = test_support::running_ensemble_case(1);
  input.film.h_lift_off = 8e-6;
  input.top_foil.formed_radius = {FormedTo::seated};  // equilibria exist at all speeds
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

/// The sample of a rotor is its command on the sampled case. @param place  of `expected` among its values
void expect_run_of_rotor(const Case& input, std::size_t place, const std::function<double(const Case&)>& expected) {
  const EnsembleCommand command = input.montecarlo->command;
  const Case sampled = sampled_case(input, draw_sample(input, 1));
  const std::vector<double> values = run_rotor_sample(sampled, command).value();
  EXPECT_EQ(values.front(), 0.0);
  EXPECT_EQ(values[place], expected(sampled));
  EXPECT_NE(values[place], expected(input));
  const std::vector<double> stopped = run_rotor_sample(sampled, command, [](double) { return false; }).value();
  EXPECT_EQ(stopped.front(), static_cast<double>(Status::interrupted));
  Case none = sampled;
  none.bump_foil.thickness = -0.1e-3;
  EXPECT_FALSE(run_rotor_sample(none, command));
}

TEST(RunningSample, OfARotorHasItsOnset) {
  expect_run_of_rotor(test_support::rotor_ensemble_case(2), 1,
                      [](const Case& input) { return run_stability(input).map.onsets.front().onset.speed; });
}

TEST(RunningSample, RespondsToUnbalanceAsItsCommandDoes) {
  expect_run_of_rotor(test_support::unbalance_ensemble_case(2), 1, [](const Case& input) {
    const UnbalanceResult result = run_unbalance(input);
    double largest = 0.0;
    for (const UnbalancePoint& point : result.points) {
      const Eigen::Vector2cd journal = result.machine.places().front().motion * point.stuck.value();
      largest = std::max(largest, elliptic_orbit(journal, point.speed).major);
    }
    return largest;
  });
}

TEST(RunningSample, MarchesInTimeAsItsCommandDoes) {
  expect_run_of_rotor(test_support::transient_ensemble_case(2), 3, [](const Case& input) {
    double largest = 0.0;
    for (const TransientTurn& revolution : turns_of(run_transient(input))) {
      largest = std::max(largest, revolution.places.front().orbit.half_peak_to_peak.maxCoeff());
    }
    return largest;
  });
}

TEST(RunningSample, CanBeStopped) {
  const Case input = test_support::running_ensemble_case(1);
  const EquilibriumResult result =
      run_running_sample(sampled_case(input, draw_sample(input, 0)), [](double) { return false; }).value();
  EXPECT_EQ(result.states[0].report.status, Status::interrupted);
}

}  // namespace
}  // namespace bumpfoil
