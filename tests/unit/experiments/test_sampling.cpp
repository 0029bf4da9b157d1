#include "bumpfoil/experiments/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/motion/response.hpp"
#include "model/case_table.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

const Sampling& sampling_of(const Case& input) {
  return *experiment_named(input.montecarlo->command).sampling;
}

/// What is found of a sampled case of the ensemble of `input`.
std::vector<SampledPlace> run_sample(const Case& input, const Case& sampled, const ProgressCallback& progress = {}) {
  return sampling_of(input).begin(input)(sampled, progress);
}

/// The names of the case file are those of the experiments that say how.
TEST(Sampling, IsOfTheExperimentsThatTheCaseFileNames) {
  std::vector<std::string_view> sampled;
  std::vector<std::string_view> swept;
  for (const ExperimentInfo& experiment : experiments()) {
    if (experiment.sampling) sampled.push_back(experiment.name);
    if (experiment.sweeping) swept.push_back(experiment.name);
  }
  EXPECT_EQ(sampled, sampled_experiments());
  EXPECT_EQ(swept, swept_experiments());
  EXPECT_GE(sampled.size(), 5U);
}

TEST(Sampling, OfRunningBearingsComesToTheStatesOfItsCase) {
  const Case input = test_support::running_ensemble_case(1);
  const EnsembleLayout layout = sampling_of(input).layout(input);
  const std::vector<SampledPlace> found = run_sample(input, sampled_case(input, draw_sample(input, 0)));
  ASSERT_EQ(found.size(), 2U);
  ASSERT_EQ(layout.places.size(), 2U);
  ASSERT_EQ(layout.coordinates.size(), 3U);
  EXPECT_EQ(layout.coordinates[1].meaning.name, "load_x");
  EXPECT_EQ(layout.coordinates[1].values, (std::vector{20.0, 40.0}));
  const EquilibriumResult alone = run_equilibrium(sampled_case(input, draw_sample(input, 0)));
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(alone.states[i].requested.journal.x(), layout.coordinates[1].values[i]);
    EXPECT_EQ(found[i].values.at(layout.column("power")), alone.states[i].outcome->power);
  }
  for (const SampledPlace& place : found) {
    EXPECT_EQ(place.values.size(), layout.columns.size());
    EXPECT_EQ(place.values.front(), 0.0);
    EXPECT_EQ(place.loads.size(), 26U);
  }
}

TEST(Sampling, HasLimitsWhereTheyAreRequested) {
  Case input = test_support::running_ensemble_case(1);
  input.film.h_lift_off = 8e-6;
  input.top_foil.formed_radius = {FormedTo::seated};  // equilibria exist at all speeds
  const Case sampled = sampled_case(input, draw_sample(input, 0));
  // Counts how often the run says where it is: limits take many more states.
  const auto reports_of = [&sampled](const Case& ensemble, std::vector<SampledPlace>& found) {
    int reports = 0;
    found = run_sample(ensemble, sampled, [&reports](double) { return ++reports > 0; });
    return reports;
  };
  const EnsembleLayout without = sampling_of(input).layout(input);
  EXPECT_EQ(without.column("lift_off_speed"), without.columns.size());
  std::vector<SampledPlace> plain, found;
  const int few = reports_of(input, plain);
  input.montecarlo->limits = true;
  EXPECT_GT(reports_of(input, found), 2 * few);
  const std::size_t lift_off = sampling_of(input).layout(input).column("lift_off_speed");
  EXPECT_GT(found[1].values.at(lift_off), found[0].values.at(lift_off));
  EXPECT_GT(found[0].values.at(lift_off), 0.0);
}

/// Ensembles count such a sample as one that is invalid, and go on.
TEST(Sampling, RefusesWhatMakesNoBearing) {
  for (const Case& input :
       {test_support::ensemble_case(1), test_support::running_ensemble_case(1), test_support::rotor_ensemble_case(1),
        test_support::unbalance_ensemble_case(1), test_support::transient_ensemble_case(1)}) {
    SCOPED_TRACE(input.montecarlo->command);
    Case sampled = sampled_case(input, draw_sample(input, 0));
    sampled.bump_foil.thickness = -0.1e-3;
    try {
      run_sample(input, sampled);
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
    }
  }
}

TEST(Sampling, CanBeStopped) {
  const Case input = test_support::running_ensemble_case(1);
  const std::vector<SampledPlace> found =
      run_sample(input, sampled_case(input, draw_sample(input, 0)), [](double) { return false; });
  const auto interrupted = std::find(running_statuses.begin(), running_statuses.end(), Status::interrupted);
  EXPECT_EQ(found[0].values.front(), static_cast<double>(interrupted - running_statuses.begin()));
}

/// The sample of a rotor is its command on the sampled case. @param place  of `expected` among its values
void expect_run_of_rotor(const Case& input, std::size_t place, const std::function<double(const Case&)>& expected) {
  const Case sampled = sampled_case(input, draw_sample(input, 1));
  const std::vector<double> values = run_sample(input, sampled).front().values;
  EXPECT_EQ(values.front(), 0.0);
  EXPECT_EQ(values[place], expected(sampled));
  EXPECT_NE(values[place], expected(input));
  const std::vector<double> stopped = run_sample(input, sampled, [](double) { return false; }).front().values;
  EXPECT_EQ(stopped.front(), static_cast<double>(Status::interrupted));
}

TEST(Sampling, OfARotorHasItsOnset) {
  expect_run_of_rotor(test_support::rotor_ensemble_case(2), 1,
                      [](const Case& input) { return run_stability(input).map.onsets.front().onset.speed; });
}

TEST(Sampling, RespondsToUnbalanceAsItsCommandDoes) {
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

TEST(Sampling, MarchesInTimeAsItsCommandDoes) {
  expect_run_of_rotor(test_support::transient_ensemble_case(2), 3, [](const Case& input) {
    double largest = 0.0;
    for (const TransientTurn& revolution : turns_of(run_transient(input))) {
      largest = std::max(largest, revolution.places.front().orbit.half_peak_to_peak.maxCoeff());
    }
    return largest;
  });
}

}  // namespace
}  // namespace bumpfoil
