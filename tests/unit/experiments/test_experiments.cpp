#include "bumpfoil/experiments/experiments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/results/result_folder.hpp"
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

/// A run replaces and refuses the files of all commands, but a case may lie beside its results.
TEST(Experiments, NameTheFilesThatIdentifyResults) {
  const std::set<std::string> names(result_names().begin(), result_names().end());
  EXPECT_EQ(names.size(), result_names().size());
  for (const ExperimentInfo& experiment : experiments()) {
    for (const std::string& name : experiment.files) EXPECT_EQ(names.contains(name), name != "case.toml") << name;
  }
  for (const char* name : {"sweep.nc", "ensemble.nc", "report.html"}) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Experiments, RunACaseToTheFilesThatTheyName) {
  Case input = reference_case();
  CycleSettings& settings = input.settings.get<CycleSettings>();
  settings.directions = {0.0};
  settings.steps = 5;
  const ExperimentInfo& cycle = experiment_named("cycle");
  const Outcome outcome = cycle.run(input, {});
  EXPECT_EQ(outcome.status, RunStatus::complete);
  EXPECT_EQ(outcome.failures, std::vector<std::string>{});
  EXPECT_NE(outcome.table().find("maximum force"), std::string::npos);
  ASSERT_TRUE(outcome.cycles);
  std::set<std::string> written;
  for (const ResultFile& file : result_files(cycle, input, outcome, {})) written.insert(file.name);
  EXPECT_EQ(written, std::set<std::string>(cycle.files.begin(), cycle.files.end()));
}

TEST(Experiments, AllWriteTheFilesThatTheyNameWithWhatFailedAndWarnings) {
  for (const ExperimentInfo& experiment : experiments()) {
    const Case input =
        parse_case(case_template("gen1"), "",
                   {.overrides = experiment.small_runs.front(), .commands = {std::string(experiment.name)}});
    Outcome outcome = experiment.run(input, {});
    outcome.failures = {"a failure"};
    outcome.warnings = {"a warning", "another"};
    std::set<std::string> written;
    for (const ResultFile& file : result_files(experiment, input, outcome, {})) {
      written.insert(file.name);
      if (file.name != "summary.json") continue;
      const auto summary = nlohmann::json::parse(file.contents);
      EXPECT_EQ(summary.at("command"), experiment.name);
      EXPECT_EQ(summary.at("failures"), nlohmann::json::array({"a failure"})) << experiment.name;
      EXPECT_EQ(summary.at("warnings"), nlohmann::json({"a warning", "another"})) << experiment.name;
    }
    std::set<std::string> named(experiment.files.begin(), experiment.files.end());
    for (std::set<std::string>* names : {&written, &named}) names->erase("case.toml");  // only with a result
    EXPECT_EQ(written, named) << experiment.name;
  }
}

TEST(Experiments, EndWhenTheirProgressSaysSo) {
  Case input = reference_case();
  input.settings.get<CycleSettings>().steps = 5;
  const Outcome outcome = experiment_named("cycle").run(input, [](double) { return false; });
  EXPECT_EQ(outcome.status, RunStatus::interrupted);
}

/// A point of a sweep has the same columns in all of its rows, and lists in JSON.
TEST(Experiments, GiveASweepRowsAndLists) {
  for (const char* const command : {"stability", "unbalance", "transient", "vibration", "equilibrium", "cycle"}) {
    SCOPED_TRACE(command);
    const ExperimentInfo& experiment = experiment_named(command);
    const Case input = parse_case(case_template("gen1"), "gen1.toml",
                                  {.overrides = experiment.small_runs.front(), .commands = {command}});
    const SweptResult swept = experiment.run(input, {}).swept(false);
    EXPECT_GT(swept.rows.columns.size(), 3U);
    EXPECT_EQ(swept.more.size(), experiment.sweeping->more_tables.size());
    EXPECT_GT(swept.rows.rows(), 0U);
    for (const TableColumn& column : swept.rows.columns) {
      EXPECT_EQ(column.values.size() + column.texts.size(), swept.rows.rows()) << column.meaning.name;
    }
    EXPECT_TRUE(nlohmann::json::parse(swept.lists).is_object());
    EXPECT_FALSE(swept.dataset.variables.empty());
  }
}

}  // namespace
}  // namespace bumpfoil
