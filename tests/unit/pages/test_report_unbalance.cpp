// Reports of rotors with unbalance: all data for the page besides the variables is present, and invalid peaks are
// rejected.

#include <gtest/gtest.h>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/unbalance/unbalance.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/reported_run.hpp"
#include "support/run_files.hpp"

namespace bumpfoil {
namespace {

using test_support::json;

/// The results folder of a rotor at four speeds with an amplitude peak between them, with periodic orbits.
class ReportOfUnbalance : public test_support::ReportedRun {
 protected:
  void SetUp() override {
    Case input = film_rotor_case({4, 4});
    input.settings.get<RotorSettings>().unbalances.emplace_back().amount = 2e-6;
    input.settings.set(UnbalanceSettings{
        .speeds = speeds_of_rpm({-4000.0, -7000.0, -10000.0, -13000.0}), .orbits = true, .steps_per_revolution = 30});
    write(test_support::files_of("unbalance", input));
  }
};

TEST_F(ReportOfUnbalance, HasResponsesPeaksAndTheWordsForThem) {
  const json run = shown();
  EXPECT_EQ(run.at("kind"), "unbalance");
  EXPECT_EQ(run.at("dimensions").at("speed"), 4);
  EXPECT_EQ(run.at("dimensions").at("kind"), 3);
  EXPECT_EQ(run.at("variables").at("phase_y").at("dims"), (json{"speed", "kind", "station"}));
  EXPECT_EQ(run.at("variables").at("h_min").at("dims"), (json{"speed", "kind", "station"}));
  EXPECT_EQ(run.at("variables").at("kind").at("words"), "linear_sliding linear_stuck orbit");
  const json& summary = run.at("summary");
  EXPECT_EQ(summary.at("stations"), json::array({"bearing 1"}));
  EXPECT_EQ(summary.at("peaks"), stored_summary().at("peaks"));
  ASSERT_FALSE(summary.at("peaks").empty());
  EXPECT_EQ(label_of(run, "equilibrium_h_min"), "minimum film thickness, equilibrium");
  EXPECT_EQ(label_of(run, "largest_amplitude"), "largest amplitude");
  EXPECT_EQ(label_of(run, "h_min"), "minimum film thickness");
  EXPECT_EQ(label_of(run, "largest_multiplier"), "largest Floquet multiplier");
  EXPECT_EQ(label_of(run, "amplitude_x_2x"), "amplitude at twice the speed, X");
  expect_words_for_all(run);
}

TEST_F(ReportOfUnbalance, RefusesPeaksThatAreNone) {
  const json peak = shown().at("summary").at("peaks").at(0);
  EXPECT_EQ(error_of("peaks", json::array({peak})), "");
  EXPECT_EQ(error_of("peaks", nullptr), "/summary.json: peaks: is missing");
  EXPECT_EQ(error_of("peaks", "none"), "/summary.json: peaks: is not a list");
  expect_refused_without("peaks", peak, json::array(), "is not a ");
  EXPECT_EQ(error_of("peaks", json::array()), "");
  EXPECT_EQ(error_of("stations", json::array({1})), "/summary.json: stations: is not a list of names");
  EXPECT_EQ(error_of("stations", nullptr), "/summary.json: stations: is missing");
}

}  // namespace
}  // namespace bumpfoil
