#include "bumpfoil/io/ensemble_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/io/checksum.hpp"
#include "bumpfoil/io/report.hpp"
#include "support/ensemble_cases.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

/// Four bearings, the last of which is none.
class EnsembleFiles : public ::testing::Test {
 protected:
  EnsembleFiles() {
    std::vector<double> rows;
    for (std::uint64_t i = 0; i < 4; ++i) {
      Case sampled = sampled_case(input_, draw_sample(input_, i));
      if (i == 3) sampled.friction.top_bump = -1.0;
      const std::vector<double> row = make_ensemble_row(layout_, sampled, run_sample(sampled));
      rows.insert(rows.end(), row.begin(), row.end());
    }
    log_.append(rows);
    const EnsembleStatistics statistics = make_ensemble_statistics(input_, layout_, log_);
    EXPECT_EQ(status_of(statistics, false), RunStatus::failed);
    EXPECT_EQ(status_of(statistics, true), RunStatus::interrupted);
    ResultFolder folder(folder_.path() / "results", Existing::refuse, ensemble_file_names());
    const EnsembleYields yields = make_yields(parse_limits({"max_force > 1 N"}, layout_), layout_, log_);
    stage_ensemble(input_, layout_, log_, statistics, yields, RunStatus::failed,
                   {.command_line = "bumpfoil", .case_text = ""}, folder);
    folder.publish();
  }

  [[nodiscard]] std::string refusal(std::size_t number, const Case& input) const {
    try {
      read_sampled_case(netcdf_, number, input, EnsembleCommand::cycle);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  [[nodiscard]] std::size_t column_of(std::string_view name) const {
    const auto found = std::find_if(layout_.columns.begin(), layout_.columns.end(),
                                    [name](const EnsembleColumn& column) { return column.name == name; });
    return static_cast<std::size_t>(found - layout_.columns.begin());
  }

  Case input_ = [] {
    Case input = testing::ensemble_case(4);
    input.solver.name = ensemble_solver(input);
    return input;
  }();
  EnsembleLayout layout_{make_ensemble_layout(input_)};
  testing::TemporaryFolder folder_;
  EnsembleLog log_{folder_.path() / "log", "", layout_.width()};
  std::filesystem::path netcdf_{folder_.path() / "results" / "ensemble.nc"};
};

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
  EXPECT_TRUE(heights.at(0).is_null());  // three samples tell nothing of 27 factors
  EXPECT_TRUE(summary.at("sensitivities").at("+X").at("max_force").contains("friction_top_bump"));
  EXPECT_EQ(summary.at("limits").at(0).at("limit"), "max_force > 1 N");
  EXPECT_EQ(summary.at("yield").at("passed"), 3);
  EXPECT_EQ(summary.at("yield").at("samples"), 4);
  ASSERT_EQ(summary.at("failed").size(), 2U);
  EXPECT_EQ(summary.at("failed").at(0).at("sample"), 3);
  EXPECT_EQ(summary.at("failed").at(0).at("direction_deg"), 0.0);
  EXPECT_EQ(summary.at("failed").at(1).at("status"), "not_physical");
}

TEST_F(EnsembleFiles, AStoredSampleIsTheOneThatWasDrawn) {
  EXPECT_EQ(read_sampled_case(netcdf_, 2, input_, EnsembleCommand::cycle),
            sampled_case(input_, draw_sample(input_, 2)));
  Case finer = input_;
  finer.cycle.steps = 400;
  finer.montecarlo.reset();
  EXPECT_EQ(read_sampled_case(netcdf_, 2, finer, EnsembleCommand::cycle).cycle.steps, 400);
}

TEST_F(EnsembleFiles, AStoredSampleIsRunByTheSolverOfItsEnsemble) {
  const auto solver = [this](std::optional<SolverName> named, EnsembleCommand command) {
    Case input = input_;
    input.solver.name = named;
    return read_sampled_case(netcdf_, 2, input, command).solver.chosen();
  };
  EXPECT_EQ(solver({}, EnsembleCommand::cycle), SolverName::events);
  EXPECT_EQ(solver(SolverName::newton, EnsembleCommand::cycle), SolverName::newton);
  EXPECT_EQ(solver({}, EnsembleCommand::equilibrium), SolverName::newton);  // events is nothing for films
}

TEST_F(EnsembleFiles, ASampleOfADamagedFileIsRefused) {
  // One bit of what was drawn: HDF5 reads it without a complaint.
  std::fstream file(netcdf_, std::ios::binary | std::ios::in | std::ios::out);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  const double deviation = draw_sample(input_, 2).height_deviations.front();
  const std::size_t place = bytes.find(std::string_view(reinterpret_cast<const char*>(&deviation), sizeof deviation));
  ASSERT_NE(place, std::string::npos);
  file.clear();
  file.seekp(static_cast<std::streamoff>(place) + 6);
  file.put(static_cast<char>(bytes[place + 6] ^ 1));
  file.close();
  EXPECT_NE(refusal(2, input_).find("is damaged: its checksum is not the one that summary.json lists"),
            std::string::npos)
      << refusal(2, input_);
  std::filesystem::remove(netcdf_.parent_path() / "summary.json");
  EXPECT_NE(refusal(2, input_).find("holds no results: summary.json is missing"), std::string::npos);
}

TEST_F(EnsembleFiles, AnotherBearingIsRefused) {
  EXPECT_NE(refusal(4, input_).find("sample = 4: is not there; give a number below 4"), std::string::npos);
  Case other = input_;
  other.bearing.radial_clearance = 30e-6;
  EXPECT_NE(refusal(0, other).find("bearing.radial_clearance = 3.18e-05: is 3e-05 in this case"), std::string::npos)
      << refusal(0, other);
  folder_.write("results/ensemble.nc", "none");
  EXPECT_NE(refusal(0, input_).find("is damaged: it has 4 bytes, where summary.json lists"), std::string::npos);
}

TEST_F(EnsembleFiles, AReportShowsDistributionsAndTheFirstBearings) {
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
      // Run again, each is the bearing that it was.
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

TEST_F(EnsembleFiles, AReportSaysWhatIsDamaged) {
  const auto fault = [this](const auto& spoil) {
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
  EXPECT_NE(fault([](json& summary) { summary["samples"] = 5; }).find("samples: is not that of ensemble.nc"),
            std::string::npos);
  EXPECT_NE(fault([](json& summary) { summary["limits"][0].erase("passed"); }).find("passed: is missing"),
            std::string::npos);
  EXPECT_NE(
      fault([](json& summary) { summary["statistics"] = 1; }).find("statistics: is no table by direction or state"),
      std::string::npos);
}

}  // namespace
}  // namespace bumpfoil
