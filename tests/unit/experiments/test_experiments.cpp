#include "bumpfoil/experiments/experiments.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bumpfoil/core/error.hpp"
#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

TEST(Experiments, SayOfThemselvesWhatACommandNeeds) {
  std::set<std::string_view> names;
  for (const ExperimentInfo& experiment : experiments()) {
    EXPECT_TRUE(names.insert(experiment.name).second) << experiment.name;
    EXPECT_FALSE(experiment.summary.empty()) << experiment.name;
    EXPECT_NE(experiment.examples.find("bumpfoil " + std::string(experiment.name)), std::string_view::npos);
    EXPECT_EQ(experiment.files.front(), "summary.json") << experiment.name;
    EXPECT_EQ(&experiment_named(experiment.name), &experiment);
  }
  for (const char* name : {"cycle", "strip", "path", "vibration", "film", "equilibrium"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(Experiments, RunACaseToTheFilesThatTheyName) {
  Case input = reference_case();
  input.cycle.directions = {0.0};
  input.cycle.steps = 5;
  const ExperimentInfo& cycle = experiment_named("cycle");
  const Outcome outcome = cycle.run(input, {});
  EXPECT_EQ(outcome.status, RunStatus::complete);
  EXPECT_EQ(outcome.failures, std::vector<std::string>{});
  EXPECT_NE(outcome.table().find("maximum force"), std::string::npos);
  ASSERT_TRUE(outcome.cycles);
  std::set<std::string> written;
  for (const ResultFile& file : outcome.files({})) written.insert(file.name);
  EXPECT_EQ(written, std::set<std::string>(cycle.files.begin(), cycle.files.end()));
}

TEST(Experiments, EndWhenTheirProgressSaysSo) {
  Case input = reference_case();
  input.cycle.steps = 5;
  const Outcome outcome = experiment_named("cycle").run(input, [](double) { return false; });
  EXPECT_EQ(outcome.status, RunStatus::interrupted);
}

}  // namespace
}  // namespace bumpfoil
