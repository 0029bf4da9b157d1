#include "bumpfoil/studies/study_report.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "bumpfoil/results/result_set.hpp"
#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

Study short_study() {
  Study study;
  study.name = "short";
  study.title = "A short study";
  study.runs.push_back({.name = "one", .label = "first", .overrides = {"cycle.steps=2"}, .parameter = {}});
  return study;
}

std::vector<StudyRunResult> results_of(const Study& study) {
  std::vector<StudyRunResult> results;
  for (const StudyRun& run : study.runs) {
    const Case input = study_case(run);
    results.push_back({input, run_cycles(input), RunStatus::complete});
  }
  return results;
}

TEST(StudyReport, CountsWhatWasRun) {
  const Study study = short_study();
  std::vector<StudyRunResult> results = results_of(study);
  const StudyOutcome outcome = outcome_of(study, results);
  EXPECT_EQ(outcome.runs, 1U);
  EXPECT_EQ(outcome.increments, 4U * 5U);
  EXPECT_TRUE(outcome.converged);
  EXPECT_GT(outcome.max_residual, 0.0);
  EXPECT_LT(outcome.max_residual, 1e-9);  // bound of the solver
  results[0].result.cycles[2].status = Status::no_modes;
  EXPECT_FALSE(outcome_of(study, results).converged);
}

TEST(StudyReport, NamesTheRunOfEveryFailure) {
  const Study study = short_study();
  std::vector<StudyRunResult> results = results_of(study);
  EXPECT_TRUE(outcome_of(study, results).failures.empty());
  results[0].result = failed_at_increment_three(results[0].result);
  const std::vector<std::string> failures = outcome_of(study, results).failures;
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0].find("short/one: +X, increment 3 of 4, "), 0U) << failures[0];
}

TEST(StudyReport, TableHasALinePerStudy) {
  const std::string table = study_outcomes_table(
      {{.name = "a", .title = "first"}, {.name = "b", .title = "second", .runs = 3, .converged = false}});
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  EXPECT_NE(table.find("second"), std::string::npos);
  EXPECT_NE(table.find("no"), std::string::npos);
}

TEST(StudyReport, JsonHoldsRunsAndTables) {
  const Study study = short_study();
  const std::vector<StudyRunResult> results = results_of(study);
  StudyTable odd{.name = "odd", .columns = {"run", "x"}, .rows = {}};
  odd.rows.push_back({std::string("one"), std::numeric_limits<double>::infinity()});
  odd.rows.push_back({std::string("one"), 2});
  const auto json =
      nlohmann::json::parse(study_json(study, results, {make_study_table(StudyTableKind::loops, study, results), odd}));
  EXPECT_EQ(json.at("schema"), "bumpfoil-study/1");
  EXPECT_EQ(json.at("study"), "short");
  EXPECT_EQ(json.at("converged"), true);
  EXPECT_EQ(json.at("runs").at(0).at("set").at(0), "cycle.steps=2");
  EXPECT_EQ(json.at("runs").at(0).at("results"), "one/summary.json");
  EXPECT_EQ(json.at("tables").at("loops").at("force_direct_N").size(), 4U * 5U);
  EXPECT_EQ(json.at("tables").at("loops").at("force_direct_N").at(2),
            results[0].result.cycles[0].increments[2].force_direct);
  EXPECT_TRUE(json.at("tables").at("odd").at("x").at(0).is_null());
  EXPECT_EQ(json.at("tables").at("odd").at("x").at(1), 2);
}

}  // namespace
}  // namespace bumpfoil
