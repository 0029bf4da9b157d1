// Reports of transient runs: of many steps, those drawn by the page are present with labels, and invalid lists are
// rejected.

#include <gtest/gtest.h>

#include <vector>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/reported_run.hpp"
#include "support/run_files.hpp"

namespace bumpfoil {
namespace {

using test_support::json;

/// The results folder of a rotor that turns a little more than 12 times, with 20 steps per revolution.
class ReportOfRunsInTime : public test_support::ReportedRun {
 protected:
  static void SetUpTestSuite() {
    Case input = film_rotor_case({4, 4});
    input.settings.get<RotorSettings>().unbalances.emplace_back().amount = 2e-6;
    input.settings.set(TransientSettings{.speed = {{.to = speed_of_rpm(-9000.0), .time = 12.5 * 60.0 / 9000.0}},
                                         .steps_per_revolution = 20,
                                         .revolutions_per_spectrum = 2});
    files_ = test_support::files_of("transient", input);
  }
  static void TearDownTestSuite() { files_.clear(); }

  void SetUp() override { write(files_); }

  static inline std::vector<ResultFile> files_;
};

TEST_F(ReportOfRunsInTime, HasAllOfAShortRunAndTheWordsForIt) {
  const json run = shown();
  EXPECT_EQ(run.at("kind"), "transient");
  EXPECT_EQ(run.at("left_out"), json::array());
  EXPECT_EQ(run.at("stored"), (json{{"revolution", 12}, {"spectrum", 6}, {"step", 251}}));
  EXPECT_EQ(run.at("dimensions").at("revolution"), 12);
  EXPECT_EQ(run.at("dimensions").at("spectrum"), 6);
  EXPECT_EQ(run.at("dimensions").at("step"), 251);
  // Consecutive revolutions share the step between them; the last one is incomplete.
  const json& orbits = run.at("orbits");
  ASSERT_EQ(orbits.size(), 13U);
  EXPECT_EQ(orbits[0], (json{{"revolution", 1}, {"first", 0}, {"steps", 21}}));
  EXPECT_EQ(orbits[1], (json{{"revolution", 2}, {"first", 20}, {"steps", 21}}));
  EXPECT_EQ(orbits[12], (json{{"revolution", 13}, {"first", 240}, {"steps", 11}}));
  EXPECT_EQ(run.at("variables").at("x").at("dims"), (json{"step", "station"}));
  EXPECT_EQ(run.at("variables").at("spectrum_amplitude").at("dims"), (json{"spectrum", "station", "axis", "order"}));
  // Energies are per revolution.
  EXPECT_FALSE(run.at("variables").contains("entrained_work"));
  const json& summary = run.at("summary");
  const json stored = stored_summary();
  for (const char* key : {"stations", "revolutions", "energy", "rubs"})
    EXPECT_EQ(summary.at(key), stored.at(key)) << key;
  EXPECT_EQ(summary.at("rub_count"), 0);
  EXPECT_EQ(label_of(run, "largest_half_peak_to_peak"), "largest half peak-to-peak");
  EXPECT_EQ(label_of(run, "amplitude_x_half"), "amplitude at half the speed, X");
  EXPECT_EQ(label_of(run, "revolution_film_dissipation"), "dissipation of films");
  expect_words_for_all(run);
}

/// Revolutions, spectra and steps each get an eighth of the numbers.
TEST_F(ReportOfRunsInTime, HasAPartOfALongRun) {
  const json whole = shown();
  const json run = shown(1600);
  EXPECT_EQ(run.at("stored"), whole.at("stored"));
  // 28 numbers per revolution, 37 per spectrum: every second one and the last.
  EXPECT_EQ(run.at("dimensions").at("revolution"), 7);
  EXPECT_EQ(run.at("dimensions").at("spectrum"), 4);
  // Consecutive orbits, up to the last one.
  const json& orbits = run.at("orbits");
  EXPECT_LT(orbits.size(), whole.at("orbits").size());
  EXPECT_EQ(orbits.back().at("revolution"), 13);
  EXPECT_EQ(orbits.at(orbits.size() - 2).at("revolution"), 12);
  EXPECT_EQ(orbits.back().at("first").get<int>() + orbits.back().at("steps").get<int>(),
            run.at("dimensions").at("step"));
  // All lists have the stated length and belong to the selected rows.
  const auto bytes_of = [](const json& of, const char* name) {
    return of.at("variables").at(name).at("values").get<std::string>();
  };
  EXPECT_EQ(bytes_of(run, "revolution_time").size(), 4U * ((7U * 4U + 2U) / 3U));
  EXPECT_NE(bytes_of(run, "x"), bytes_of(whole, "x").substr(0, bytes_of(run, "x").size()));
  const std::string first = bytes_of(run, "revolution");
  EXPECT_EQ(first.substr(0, 5), bytes_of(whole, "revolution").substr(0, 5));
  EXPECT_LT(run.dump().size(), whole.dump().size());
}

TEST_F(ReportOfRunsInTime, RefusesListsThatAreNone) {
  const json rub{{"bearing", 1}, {"begin_s", 0.01}, {"end_s", 0.02}, {"asperity_load_N", 3.0}};
  EXPECT_EQ(error_of("rubs", json::array({rub})), "");
  EXPECT_EQ(shown().at("summary").at("rubs"), json::array({rub}));
  EXPECT_EQ(error_of("rubs", json(std::vector<json>(1200, rub))), "");
  EXPECT_EQ(shown().at("summary").at("rubs").size(), 1000U);
  EXPECT_EQ(shown().at("summary").at("rub_count"), 1200);
  expect_refused_without("rubs", rub, "none", "is not a");
  EXPECT_EQ(error_of("rubs", nullptr), "/summary.json: rubs: is missing");
  EXPECT_EQ(error_of("rubs", "none"), "/summary.json: rubs: is not a list");
  EXPECT_EQ(error_of("rubs", json::array()), "");
  EXPECT_EQ(error_of("energy", {{"forces_J", "much"}}), "/summary.json: forces_J: is not a number");
  EXPECT_EQ(error_of("energy", 1), "/summary.json: energy: is not a table");
  EXPECT_EQ(error_of("energy", json::object()), "");
  EXPECT_EQ(error_of("revolutions", -1), "/summary.json: revolutions: is not an integer");
  EXPECT_EQ(error_of("revolutions", 12), "");
  EXPECT_EQ(error_of("stations", nullptr), "/summary.json: stations: is missing");
}

}  // namespace
}  // namespace bumpfoil
