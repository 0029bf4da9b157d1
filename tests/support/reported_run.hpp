#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil::test_support {

using nlohmann::json;

/// A folder with the results of a command, and its report.
class ReportedRun : public testing::Test {
 protected:
  void write(const std::vector<ResultFile>& files) const {
    for (const ResultFile& file : files) folder_.write(file.name, file.contents);
  }

  [[nodiscard]] json shown(std::size_t most_values = most_report_values) const {
    return json::parse(report_json({folder_.path()}, {.most_values = most_values})).at("runs").at(0);
  }

  [[nodiscard]] json stored_summary() const { return json::parse(folder_.read("summary.json")); }

  /// Error message of a report for a changed value in the summary; null removes it.
  [[nodiscard]] std::string error_of(const std::string& key, const json& value) const {
    json changed = stored_summary();
    changed[key] = value;
    if (value.is_null()) changed.erase(key);
    changed["xxh3_128"] = blank_checksum;
    folder_.write("summary.json", sealed(changed.dump()));
    try {
      report_json({folder_.path()});
      return "";
    } catch (const Error& error) {
      return std::string(error.what()).substr(folder_.path().string().size());
    }
  }

  /// Checks that list entries in the summary are rejected if a value is missing or replaced.
  /// @param error  expected start of the message about a replaced value
  void expect_refused_without(const std::string& list, const json& entry, const json& other,
                              const std::string& error) const {
    for (const auto& [key, value] : entry.items()) {
      json spoilt = entry;
      spoilt.erase(key);
      EXPECT_EQ(error_of(list, json::array({entry, spoilt})), "/summary.json: " + key + ": is missing");
      spoilt[key] = other;
      EXPECT_EQ(error_of(list, json::array({spoilt})).find("/summary.json: " + key + ": " + error), 0U) << key;
    }
  }

  /// The label of a quantity of a run that is shown; empty where it has none.
  static std::string label_of(const json& run, const std::string& name) {
    const json& all = run.at("quantities");
    const auto found = std::find_if(all.begin(), all.end(), [&](const json& one) { return one.at("name") == name; });
    return found == all.end() ? "" : found->at("label").get<std::string>();
  }

  static void expect_words_for_all(const json& run) {
    for (const json& quantity : run.at("quantities")) {
      EXPECT_TRUE(run.at("variables").contains(quantity.at("name"))) << quantity;
      EXPECT_FALSE(quantity.at("meaning").get<std::string>().empty()) << quantity;
    }
  }

  TemporaryFolder folder_;
};

}  // namespace bumpfoil::test_support
