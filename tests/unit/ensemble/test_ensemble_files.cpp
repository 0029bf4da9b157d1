#include "bumpfoil/ensemble/ensemble_files.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bumpfoil/results/checksum.hpp"
#include "support/ensemble_files.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;
using test_support::EnsembleFiles;

TEST_F(EnsembleFiles, SummaryTellsStatisticsAndFailures) {
  const json summary = json::parse(folder_.read("results/summary.json"));
  EXPECT_EQ(summary.at("command"), "montecarlo");
  EXPECT_EQ(summary.at("status"), "failed");
  EXPECT_EQ(summary.at("samples"), 4);
  EXPECT_EQ(summary.at("samples_due"), 4);
  EXPECT_EQ(summary.at("seed"), 1);
  EXPECT_EQ(summary.at("files").at("ensemble.nc").at("xxh3_128"), xxh3_128(folder_.read("results/ensemble.nc")));
  const json& force = summary.at("statistics").at("-X").at("max_force_N");
  EXPECT_EQ(force.at("count"), 3);
  EXPECT_EQ(force.at("undefined"), 0);
  for (const char* key : {"mean", "std", "standard_error", "p1", "p5", "p25", "p50", "p75", "p95", "p99"}) {
    EXPECT_TRUE(force.at(key).is_number()) << key;
  }
  EXPECT_LT(force.at("mean_interval_95").at(0), force.at("mean"));
  for (const char* key : {"loaded_stiffness_N_per_m", "loop_energy_J", "loss_factor", "clearance_5N_m",
                          "clearance_10N_m", "initial_journal_load_N", "tangent_stiffness_loading_N_per_m",
                          "tangent_stiffness_unloading_N_per_m", "largest_bump_load_N"}) {
    EXPECT_TRUE(summary.at("statistics").at("+X").contains(key)) << key;
  }
  EXPECT_EQ(summary.at("bump_loads").at("+X").at("mean_N").size(), 26U);
  const json& heights = summary.at("sensitivities").at("+X").at("max_force").at("bump_height");
  ASSERT_EQ(heights.size(), 26U);
  EXPECT_TRUE(heights.at(0).is_null());  // three samples do not determine 27 factors
  EXPECT_TRUE(summary.at("sensitivities").at("+X").at("max_force").contains("friction_top_bump"));
  EXPECT_EQ(summary.at("limits").at(0).at("limit"), "max_force > 1 N");
  EXPECT_EQ(summary.at("yield").at("passed"), 3);
  EXPECT_EQ(summary.at("yield").at("samples"), 4);
  ASSERT_EQ(summary.at("failed").size(), 2U);
  EXPECT_EQ(summary.at("failed").at(0).at("sample"), 3);
  EXPECT_EQ(summary.at("failed").at(0).at("direction_deg"), 0.0);
  EXPECT_EQ(summary.at("failed").at(1).at("status"), "not_physical");
}

}  // namespace
}  // namespace bumpfoil
