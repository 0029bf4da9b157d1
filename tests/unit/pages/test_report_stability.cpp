// Reports of rotors: what the page needs beside the variables is there, and onsets that are none are refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

/// The folder of a rotor of 2 kg at two speeds, between which it begins to whirl.
class ReportOfRotors : public testing::Test {
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
    for (const ResultFile& file : experiment_named("stability").run(input, {}).files({})) {
      folder_.write(file.name, file.contents);
    }
  }

  [[nodiscard]] json shown() const { return json::parse(report_json({folder_.path()})).at("runs").at(0); }

  /// What a report says of the folder with other onsets.
  [[nodiscard]] std::string fault_of_onsets(const json& onsets) const {
    json summary = json::parse(folder_.read("summary.json"));
    if (onsets.is_null()) {
      summary.erase("onsets");
    } else {
      summary["onsets"] = onsets;
    }
    summary["xxh3_128"] = blank_checksum;
    folder_.write("summary.json", sealed(summary.dump()));
    try {
      report_json({folder_.path()});
      return "";
    } catch (const Error& error) {
      return std::string(error.what()).substr(folder_.path().string().size());
    }
  }

  test_support::TemporaryFolder folder_;
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
  EXPECT_EQ(onsets, json::parse(folder_.read("summary.json")).at("onsets"));
  ASSERT_FALSE(onsets.empty());
  EXPECT_EQ(onsets[0].at("begins"), true);
  // Of the whole run, of a speed and of a motion, each with words; which motion it is, is none of them.
  const auto label_of = [&](const std::string& name) -> std::string {
    const json& all = run.at("quantities");
    const auto found = std::find_if(all.begin(), all.end(), [&](const json& one) { return one.at("name") == name; });
    return found == all.end() ? "" : found->at("label").get<std::string>();
  };
  EXPECT_EQ(label_of("onset_speed"), "onset of whirl");
  EXPECT_EQ(label_of("h_min"), "minimum film thickness");
  EXPECT_EQ(label_of("speed_status"), "status");
  EXPECT_EQ(label_of("imag"), "damped frequency");
  EXPECT_EQ(label_of("mode") + label_of("contacts"), "");
  for (const json& quantity : run.at("quantities")) {
    EXPECT_TRUE(run.at("variables").contains(quantity.at("name"))) << quantity;
    EXPECT_FALSE(quantity.at("meaning").get<std::string>().empty()) << quantity;
  }
}

TEST_F(ReportOfRotors, RefusesOnsetsThatAreNone) {
  const json onset = shown().at("summary").at("onsets").at(0);
  EXPECT_EQ(fault_of_onsets(json::array({onset})), "");
  EXPECT_EQ(fault_of_onsets(nullptr), "/summary.json: onsets: is missing");
  EXPECT_EQ(fault_of_onsets("none"), "/summary.json: onsets: is not a list");
  for (const auto& [key, value] : onset.items()) {
    json spoilt = onset;
    spoilt.erase(key);
    EXPECT_EQ(fault_of_onsets(json::array({onset, spoilt})), "/summary.json: " + key + ": is missing");
    spoilt[key] = json::array();
    EXPECT_EQ(fault_of_onsets(json::array({spoilt})).find("/summary.json: " + key + ": is n"), 0U) << key;
  }
}

}  // namespace
}  // namespace bumpfoil
