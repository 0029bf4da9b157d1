// Reports of rotors: all data for the page besides the variables is present, and invalid onsets are rejected.

#include <gtest/gtest.h>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/reported_run.hpp"
#include "support/run_files.hpp"

namespace bumpfoil {
namespace {

using test_support::json;

/// The results folder of a rotor of 2 kg at two speeds, with an onset of whirl between them.
class ReportOfRotors : public test_support::ReportedRun {
 protected:
  void SetUp() override {
    Case input = film_reference_case({6, 8});
    RotorSettings rotor;
    rotor.mass = 2.0;
    rotor.gravity = {9.81, 0.0};
    input.settings.set(rotor);
    StabilitySettings settings;
    settings.speeds = {speed_of_rpm(-12600.0), speed_of_rpm(-13200.0)};
    input.settings.set(settings);
    write(test_support::files_of("stability", input));
  }
};

TEST_F(ReportOfRotors, HasMotionsOnsetsAndTheWordsForThem) {
  const json run = shown();
  EXPECT_EQ(run.at("kind"), "stability");
  EXPECT_EQ(run.at("left_out"), json::array());
  EXPECT_EQ(run.at("dimensions").at("speed"), 2);
  EXPECT_EQ(run.at("variables").at("real").at("dims"), (json{"speed", "contacts", "mode"}));
  EXPECT_EQ(run.at("variables").at("contacts").at("words"), "sliding stuck");
  EXPECT_EQ(run.at("variables").at("shape_phase_y").at("dims"), (json{"speed", "contacts", "mode", "station"}));
  const json& onsets = run.at("summary").at("onsets");
  EXPECT_EQ(onsets, stored_summary().at("onsets"));
  ASSERT_FALSE(onsets.empty());
  EXPECT_EQ(onsets[0].at("begins"), true);
  // Quantities of the whole run, of a speed and of a motion have labels; the number of the motion has none.
  EXPECT_EQ(label_of(run, "onset_speed"), "onset of whirl");
  EXPECT_EQ(label_of(run, "h_min"), "minimum film thickness");
  EXPECT_EQ(label_of(run, "speed_status"), "status");
  EXPECT_EQ(label_of(run, "imag"), "damped frequency");
  EXPECT_EQ(label_of(run, "mode") + label_of(run, "contacts"), "");
  expect_words_for_all(run);
}

TEST_F(ReportOfRotors, RefusesOnsetsThatAreNone) {
  const json onset = shown().at("summary").at("onsets").at(0);
  EXPECT_EQ(error_of("onsets", json::array({onset})), "");
  EXPECT_EQ(error_of("onsets", nullptr), "/summary.json: onsets: is missing");
  EXPECT_EQ(error_of("onsets", "none"), "/summary.json: onsets: is not a list");
  expect_refused_without("onsets", onset, json::array(), "is n");
}

}  // namespace
}  // namespace bumpfoil
