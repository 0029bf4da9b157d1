#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/pages/report.hpp"
#include "support/ensemble_files.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

class ReportOfEnsembles : public test_support::EnsembleFiles {
 protected:
  [[nodiscard]] std::size_t column_of(std::string_view name) const {
    const auto found = std::find_if(layout_.columns.begin(), layout_.columns.end(),
                                    [name](const EnsembleColumn& column) { return column.meaning.name == name; });
    return static_cast<std::size_t>(found - layout_.columns.begin());
  }
};

TEST_F(ReportOfEnsembles, AReportShowsDistributionsAndTheFirstBearings) {
  const json run = json::parse(report_json({folder_.path() / "results"})).at("runs").at(0);
  EXPECT_EQ(run.at("kind"), "montecarlo");
  EXPECT_EQ(run.at("directions"), (json{0.0, 180.0}));
  EXPECT_EQ(run.at("summary").at("statistics"), json::parse(folder_.read("results/summary.json")).at("statistics"));
  EXPECT_FALSE(run.at("summary").contains("failed"));
  for (const json& quantity : run.at("quantities")) {
    EXPECT_TRUE(run.at("distributions").contains(quantity.at("name"))) << quantity;
    EXPECT_TRUE(run.at("summary").at("statistics").at("+X").contains(quantity.at("key"))) << quantity;
  }
  const std::size_t column = column_of("max_force");
  const json& force = run.at("distributions").at("max_force");
  double least = 1e9;
  double most = 0.0;
  for (std::size_t direction = 0; direction < 2; ++direction) {
    const std::vector<double> forces = log_.column(layout_.entry(direction, column), 0, 4);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(force.at("first").at(direction).at(i), forces[i]);
      least = std::min(least, forces[i]);
      most = std::max(most, forces[i]);
      // Each bearing is reproduced in a new run.
      const json& sample = run.at("samples").at(i);
      EXPECT_EQ(sample.at("name"), fmt::format("Sample {}", i));
      EXPECT_EQ(sample.at("sample"), i);
      EXPECT_NEAR(sample.at("summary").at("cycles").at(direction).at("max_force_N").get<double>(), forces[i],
                  1e-9 * forces[i]);
    }
    EXPECT_TRUE(force.at("first").at(direction).at(3).is_null());
    const auto counts = force.at("counts").at(direction).get<std::vector<int>>();
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 3);
  }
  EXPECT_EQ(force.at("from"), least);
  EXPECT_EQ(force.at("to"), most);
}

TEST_F(ReportOfEnsembles, AReportSaysWhatIsDamaged) {
  const auto error = [this](const auto& spoil) {
    json summary = json::parse(folder_.read("results/summary.json"));
    spoil(summary);
    folder_.write("results/summary.json", summary.dump());
    try {
      report_json({folder_.path() / "results"}, {.checked = false});
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(error([](json& summary) { summary["samples"] = 5; }).find("samples: differs from that of ensemble.nc"),
            std::string::npos);
  EXPECT_NE(error([](json& summary) { summary["limits"][0].erase("passed"); }).find("passed: is missing"),
            std::string::npos);
  EXPECT_NE(
      error([](json& summary) { summary["statistics"] = 1; }).find("statistics: is not a table by direction or state"),
      std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
