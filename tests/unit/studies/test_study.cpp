#include "bumpfoil/studies/study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/reference_case.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view smallest = R"(
title = "A study"
tables = ["loops"]
[[run]]
name = "one"
label = "first"
)";

TEST(Study, EveryStudyOfTheProgramCanBeRun) {
  for (const std::string& name : study_names()) {
    SCOPED_TRACE(name);
    const Study study = make_study(name);
    EXPECT_EQ(study.name, name);
    EXPECT_NE(study.plot_script.find("eval panels("), std::string::npos);
    std::set<std::string> names;
    for (const StudyRun& run : study.runs) {
      EXPECT_TRUE(names.insert(run.name).second) << run.name;
      EXPECT_NO_THROW(study_case(run)) << run.name;
    }
  }
}

TEST(Study, HasTheFiguresOfThePaperFirst) {
  const std::vector<std::string> names = study_names();
  ASSERT_GE(names.size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(names[i], "figure" + std::to_string(10 + i));
  EXPECT_EQ(make_study("figure10").runs.size(), 4U);
  EXPECT_EQ(make_study("figure15").runs.size(), 13U);  // the perfect bearing only once
  EXPECT_EQ(make_study("figure16").runs.size(), 1U);
}

TEST(Study, TheReferenceCaseIsTheBase) {
  EXPECT_EQ(study_case(make_study("figure10").runs.front()), reference_case());
}

TEST(Study, ScatteredHeightsAreThoseOfTheirDistribution) {
  for (const auto& [name, deviation] : {std::pair{"figure13", 10e-6}, std::pair{"figure14", 20e-6}}) {
    std::vector<double> all;
    for (const StudyRun& run : make_study(name).runs) {
      const std::vector<double> errors = study_case(run).bump_foil.height_errors;
      EXPECT_EQ(errors.size(), run.name == "perfect" ? 0U : 26U);
      all.insert(all.end(), errors.begin(), errors.end());
    }
    ASSERT_EQ(all.size(), 6U * 26U);
    const double n = static_cast<double>(all.size());
    const double mean = std::accumulate(all.begin(), all.end(), 0.0) / n;
    double squares = 0.0;
    for (const double error : all) squares += (error - mean) * (error - mean);
    // Three standard errors of the mean, s/sqrt(n), and of the standard deviation, s/sqrt(2 n).
    EXPECT_NEAR(mean, 0.0, 3.0 * deviation / std::sqrt(n));
    EXPECT_NEAR(std::sqrt(squares / (n - 1.0)), deviation, 3.0 * deviation / std::sqrt(2.0 * n));
  }
}

TEST(Study, SweepsMakeARunForEachValue) {
  const Study study = parse_study(R"(
title = "Clearance"
set = ["friction.coefficient=0"]
tables = ["quantities", "loads"]
[[sweep]]
name = "clearance"
over = "bearing.radial_clearance=[-10 um, 2.5 um]"
)",
                                  "clearance");
  EXPECT_EQ(study.parameter, "radial_clearance");
  EXPECT_EQ(study.parameter_unit, "um");
  ASSERT_EQ(study.runs.size(), 2U);
  EXPECT_EQ(study.runs[0].name, "clearance_-10um");
  EXPECT_EQ(study.runs[1].parameter, 2.5);
  const Case input = study_case(study.runs[1]);
  EXPECT_DOUBLE_EQ(input.bearing.radial_clearance, 2.5e-6);
  EXPECT_EQ(input.friction.top_bump, 0.0);
  EXPECT_EQ(study.tables, (std::vector{StudyTableKind::quantities, StudyTableKind::loads}));
}

TEST(Study, LineBreaksInOverridesAreSpaces) {
  const std::string text = std::string(smallest) + "set = ['''bump_foil.sleeve_gaps=[\n0]''']\n";
  EXPECT_EQ(parse_study(text, "broken").runs[0].overrides, std::vector<std::string>{"bump_foil.sleeve_gaps=[ 0]"});
}

TEST(Study, TakesRunsOfOthers) {
  const Study study = parse_study(R"(
title = "Two of four"
runs_of = ["figure10", "figure11"]
only = ["present-friction", "former-friction"]
tables = ["loads"]
)",
                                  "two");
  ASSERT_EQ(study.runs.size(), 2U);
  EXPECT_EQ(study.runs[0].name, "present-friction");
  EXPECT_EQ(study.runs[1].overrides, std::vector<std::string>{"bump_foil.model=former"});
}

TEST(Study, VariantsRepeatTheRunsOfOthers) {
  const Study study = parse_study(R"(
title = "Two by two"
runs_of = ["figure10"]
only = ["present-friction", "present-frictionless"]
tables = ["loads"]
[[variant]]
name = "truss"
[[variant]]
name = "frame"
set = ["bump_foil.model=frame"]
)",
                                  "variants");
  ASSERT_EQ(study.runs.size(), 4U);
  EXPECT_EQ(study.runs[1].name, "present-frictionless-truss");
  EXPECT_EQ(study.runs[1].overrides, std::vector<std::string>{"friction.coefficient=0"});
  EXPECT_EQ(study.runs[3].name, "present-frictionless-frame");
  EXPECT_EQ(study_case(study.runs[3]).bump_foil.model, BumpFoilModel::frame);
  EXPECT_EQ(study_case(study.runs[3]).friction.top_bump, 0.0);
}

TEST(Study, DataFromElsewhereHasTheColumnsOfTheLoops) {
  const Study study = make_study("figure12");
  ASSERT_EQ(study.data.size(), 1U);
  EXPECT_TRUE(study.data[0].csv.starts_with(
      "run,direction_deg,increment,branch,displacement_m,force_direct_N,force_cross_N\n"));
}

TEST(Study, WrongDescriptionsAreToldByKey) {
  const std::string text(smallest);
  const auto key_of_error = [](const std::string& description) {
    try {
      (void)parse_study(description, "wrong");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_EQ(error.errors().front().file, "wrong");
      return error.errors().front().key;
    }
    return std::string("none");
  };
  EXPECT_EQ(key_of_error(text), "none");
  EXPECT_EQ(key_of_error("tables = [\"loops\"]"), "title");
  EXPECT_EQ(key_of_error("colour = 1\n" + text), "colour");
  EXPECT_EQ(key_of_error(text + "colour = 1\n"), "colour");
  EXPECT_EQ(key_of_error("title = \"\"\ntables = [\"loops\"]"), "run");
  EXPECT_EQ(key_of_error("tables = [\"loop\"]\ntitle = \"\""), "tables");
  EXPECT_EQ(key_of_error("data = [\"nowhere\"]\n" + text), "data");
  EXPECT_EQ(key_of_error("runs_of = 3\n" + text), "runs_of");
  EXPECT_EQ(key_of_error("increments = [\"a\"]\n" + text), "increments");
}

TEST(Study, BrokenDescriptionsAreToldByLine) {
  try {
    (void)parse_study("title = \"a\"\nruns =", "broken");
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.errors().front().file, "broken");
    EXPECT_EQ(error.errors().front().line, 2U);
  }
}

TEST(Study, UnknownNamesAreTold) {
  EXPECT_THROW((void)make_study("figure9"), Error);
  StudyRun run{.name = "wrong", .label = "", .overrides = {"friction.coefficient=much"}, .parameter = {}};
  EXPECT_THROW((void)study_case(run), Error);
}

}  // namespace
}  // namespace bumpfoil
