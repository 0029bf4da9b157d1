// Reports of rotors with unbalance: what the page needs beside the variables is there, and peaks that are none are
// refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/unbalance/unbalance.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

/// The folder of a rotor at four speeds, among which its orbit is largest, with periodic orbits.
class ReportOfUnbalance : public testing::Test {
 protected:
  void SetUp() override {
    Case input = film_rotor_case({4, 4});
    input.settings.find<RotorSettings>()->unbalances.emplace_back().amount = 2e-6;
    input.settings.set(UnbalanceSettings{
        .speeds = speeds_of_rpm({-4000.0, -7000.0, -10000.0, -13000.0}), .orbits = true, .steps_per_revolution = 30});
    for (const ResultFile& file : experiment_named("unbalance").run(input, {}).files({})) {
      folder_.write(file.name, file.contents);
    }
  }

  [[nodiscard]] json shown() const { return json::parse(report_json({folder_.path()})).at("runs").at(0); }

  /// What a report says of the folder with another value in its summary; null removes it.
  [[nodiscard]] std::string fault_of(const std::string& key, const json& value) const {
    json summary = json::parse(folder_.read("summary.json"));
    summary[key] = value;
    if (value.is_null()) summary.erase(key);
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
  EXPECT_EQ(summary.at("peaks"), json::parse(folder_.read("summary.json")).at("peaks"));
  ASSERT_FALSE(summary.at("peaks").empty());
  const auto label_of = [&](const std::string& name) -> std::string {
    const json& all = run.at("quantities");
    const auto found = std::find_if(all.begin(), all.end(), [&](const json& one) { return one.at("name") == name; });
    return found == all.end() ? "" : found->at("label").get<std::string>();
  };
  EXPECT_EQ(label_of("equilibrium_h_min"), "minimum film thickness, equilibrium");
  EXPECT_EQ(label_of("largest_amplitude"), "largest amplitude");
  EXPECT_EQ(label_of("h_min"), "minimum film thickness");
  EXPECT_EQ(label_of("largest_multiplier"), "largest Floquet multiplier");
  EXPECT_EQ(label_of("amplitude_x_2x"), "amplitude at twice the speed, X");
  for (const json& quantity : run.at("quantities")) {
    EXPECT_TRUE(run.at("variables").contains(quantity.at("name"))) << quantity;
    EXPECT_FALSE(quantity.at("meaning").get<std::string>().empty()) << quantity;
  }
}

TEST_F(ReportOfUnbalance, RefusesPeaksThatAreNone) {
  const json peak = shown().at("summary").at("peaks").at(0);
  EXPECT_EQ(fault_of("peaks", json::array({peak})), "");
  EXPECT_EQ(fault_of("peaks", nullptr), "/summary.json: peaks: is missing");
  EXPECT_EQ(fault_of("peaks", "none"), "/summary.json: peaks: is not a list");
  for (const auto& [key, value] : peak.items()) {
    json spoilt = peak;
    spoilt.erase(key);
    EXPECT_EQ(fault_of("peaks", json::array({peak, spoilt})), "/summary.json: " + key + ": is missing");
    spoilt[key] = json::array();
    EXPECT_EQ(fault_of("peaks", json::array({spoilt})).find("/summary.json: " + key + ": is not a "), 0U) << key;
  }
  EXPECT_EQ(fault_of("peaks", json::array()), "");
  EXPECT_EQ(fault_of("stations", json::array({1})), "/summary.json: stations: is not a list of names");
  EXPECT_EQ(fault_of("stations", nullptr), "/summary.json: stations: is missing");
}

}  // namespace
}  // namespace bumpfoil
