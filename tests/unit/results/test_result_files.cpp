#include "results/result_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "results/netcdf_image.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

class StagedResultFiles : public ::testing::Test {
 protected:
  void stage(const Dataset& dataset) {
    const Provenance provenance{.command_line = "bumpfoil", .case_text = ""};
    ResultFolder folder(folder_.path() / "results", Existing::refuse, {"summary.json", "numbers.nc"});
    stage_result_files(
        {.input = input_, .command = "montecarlo", .status = RunStatus::complete, .provenance = provenance},
        "numbers.nc", "use fewer samples", dataset, {{"samples", 25'000}}, folder);
    folder.publish();
  }

  Case input_;
  test_support::TemporaryFolder folder_;
};

TEST_F(StagedResultFiles, HoldRowsThatAreReadInPieces) {
  constexpr std::size_t samples = 25'000;
  Dataset dataset;
  dataset.add_dimension({"sample", "1", "sample", whole_number}, numbers_from(0.0, samples));
  dataset.add_dimension({"bump", "1", "bump", whole_number}, numbers_from(1.0, 2));
  std::size_t most = 0;
  dataset.add({"load", "N", "load"}, {"sample", "bump"}).rows = [&most](std::size_t first, std::size_t count) {
    most = std::max(most, count);
    return numbers_from(2.0 * static_cast<double>(first), 2 * count);
  };
  stage(dataset);
  const std::string bytes = folder_.read("results/numbers.nc");
  const NetcdfImage file(bytes, "numbers.nc");
  EXPECT_EQ(file.numbers(file.variable("load", {"sample", "bump"})), numbers_from(0.0, 2 * samples));
  EXPECT_LT(most, samples);
  const auto summary = nlohmann::json::parse(folder_.read("results/summary.json"));
  EXPECT_EQ(summary.at("samples"), samples);
  EXPECT_EQ(summary.at("run_id"), file.texts().at("run_id"));
  EXPECT_EQ(summary.at("files").at("numbers.nc").at("xxh3_128"), xxh3_128(bytes));
}

#if !defined(BUMPFOIL_SANITIZED)  // sanitizers keep freed memory
/// A column of a million rows is never in memory as a whole, and written rows take at most half a megabyte.
TEST_F(StagedResultFiles, TakeNoMemoryForRows) {
  constexpr std::size_t rows = 1'000'000;
  constexpr std::size_t columns = 6;
  Dataset dataset;
  dataset.dims.push_back({.name = "step", .size = rows, .grows = true});
  for (std::size_t i = 0; i < columns; ++i) {
    Variable& variable = dataset.add({fmt::format("x{}", i), "m", "a column"}, {"step"});
    variable.compressed = true;
    variable.rows = [](std::size_t first, std::size_t count) {
      return numbers_from(static_cast<double>(first), count);
    };
  }
  const auto most_memory = [] {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss;  // kB
  };
  const auto before = most_memory();
  stage(dataset);
  EXPECT_LT(most_memory() - before, 20'000);  // all columns take 48 MB
}
#endif

/// With and without times: the rest is the same.
TEST(ResultFiles, LeaveOutTimes) {
  const Case input;
  const auto make = [&input](bool times) {
    const Provenance provenance{.command_line = "bumpfoil", .case_text = "text", .times = times};
    return make_result_files({.input = input,
                              .command = "vibration",
                              .status = RunStatus::failed,
                              .failures = {"no modes", "no tangent"},
                              .warnings = {"careful"},
                              .provenance = provenance},
                             "result.nc", "", [](const std::string& run_id) {
                               ResultContents contents;
                               Table timed;
                               timed.add({"a", "1", ""}, {1.0, absent});
                               timed.add({"wall_time", "s", ""}, {0.5, absent});
                               timed.add({"b", "", ""}, std::vector<std::string>{"word", "x, y"});
                               Table other;
                               other.add({"a", "1", ""}, std::vector<double>{1.0});
                               contents.tables = {{"loops.csv", timed}, {"other.csv", other}};
                               contents.texts = {{"case.toml", "a,wall_time_s\n" + run_id}};
                               contents.dataset.add({"wall_time", "s", "time"}, {}, std::vector<double>{0.5});
                               contents.dataset.add({"force", "N", "force"}, {}, std::vector<double>{3.0});
                               contents.lists = {{"loops", {{{"force_N", 3.0}, {"wall_time_s", 0.5}}}}};
                               return contents;
                             });
  };
  const std::vector<ResultFile> files = make(false);
  const std::vector<ResultFile> timed = make(true);
  ASSERT_EQ(files.size(), 5U);
  EXPECT_EQ(files[0].contents, "a,b\n1,word\n,\"x, y\"\n");
  EXPECT_EQ(timed[0].contents, "a,wall_time_s,b\n1,0.5,word\n,,\"x, y\"\n");
  EXPECT_EQ(files[1].contents, "a\n1\n");
  const auto summary = nlohmann::json::parse(files[4].contents);
  EXPECT_EQ(summary.at("failures"), nlohmann::json({"no modes", "no tangent"}));
  EXPECT_EQ(summary.at("warnings"), nlohmann::json::array({"careful"}));
  EXPECT_EQ(summary.at("loops").at(0), nlohmann::json({{"force_N", 3.0}}));
  EXPECT_EQ(nlohmann::json::parse(timed[4].contents).at("loops").at(0).at("wall_time_s"), 0.5);
  EXPECT_EQ(files[2].contents, "a,wall_time_s\n" + summary.at("run_id").get<std::string>());
  const NetcdfImage file(files[3].contents, "result.nc");
  const NetcdfImage with_times(timed[3].contents, "result.nc");
  EXPECT_EQ(file.numbers(file.variable("force", {})), std::vector<double>{3.0});
  EXPECT_EQ(file.texts().at("status_message"), "no modes; no tangent");
  EXPECT_EQ(file.texts().at("warnings"), "careful");
  EXPECT_FALSE(file.variables().contains("wall_time"));
  EXPECT_TRUE(with_times.variables().contains("wall_time"));
  for (const char* told : {"date_created", "history"}) {
    EXPECT_FALSE(file.texts().contains(told)) << told;
    EXPECT_TRUE(with_times.texts().contains(told)) << told;
  }
  EXPECT_EQ(file.texts().at("case_text"), "text");
  EXPECT_EQ(make(false)[4].contents, files[4].contents);
  EXPECT_NE(make(true)[4].contents, timed[4].contents);
}

TEST_F(StagedResultFiles, AreRefusedWhereTheDiskHasNoRoom) {
  Dataset dataset;
  dataset.dims = {{"sample", std::size_t{1} << 50U}};
  dataset.add({"load", "N", "load"}, {"sample"}).rows = [](std::size_t, std::size_t count) {
    return std::vector<double>(count);
  };
  try {
    stage(dataset);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::file);
    EXPECT_NE(std::string(error.what()).find("/numbers.nc: takes up to"), std::string::npos) << error.what();
  }
}

/// Rows of a march, only a few of them in memory at a time.
TEST_F(StagedResultFiles, AreWrittenAsTheyCome) {
  std::vector<double> loads, torques;
  Dataset dataset;
  dataset.dims = {{.name = "step", .grows = true}};
  dataset.add_dimension({"bump", "1", "bump", whole_number}, numbers_from(1.0, 2));
  dataset.dims.push_back({.name = "event", .grows = true});
  dataset.coordinates.push_back({.meaning = {"step", "1", "step", whole_number},
                                 .dims = {"step"},
                                 .values = [&] { return loads.empty() ? loads : numbers_from(loads[0], 2); },
                                 .known = true});
  VariableMeaning torque{"torque", "N m", "torque"};
  torque.tags = tag::csv;
  dataset.add(torque, {"step"}, [&] { return torques; });
  dataset.add({"load", "N", "load"}, {"step", "bump"}, [&] { return loads; }).compressed = true;
  dataset.add({"event_load", "N", "load"}, {"event"}, [] { return std::vector<double>(); });
  const Provenance provenance{.command_line = "bumpfoil", .case_text = ""};
  ResultFolder folder(folder_.path() / "results", Existing::refuse, {"summary.json", "steps.csv", "numbers.nc"});
  ResultStream stream({.netcdf = "numbers.nc", .csv = "steps.csv"}, dataset, folder);
  for (int block = 0; block < 500; ++block) {
    loads = numbers_from(2.0 * block, 4);
    torques = {0.5 * block, absent};
    stream.append();
  }
  Dataset totals;
  totals.add({"work", "J", "work"}, {}, std::vector<double>{7.0});
  stream.finish({.input = input_, .command = "transient", .status = RunStatus::complete, .provenance = provenance},
                totals, {{"steps", 1000}});
  folder.publish();
  const NetcdfImage file(folder_.read("results/numbers.nc"), "numbers.nc");
  ASSERT_EQ(file.size_of("step"), 1000U);
  EXPECT_FALSE(file.variables().contains("event_load"));
  EXPECT_EQ(file.numbers(file.variable("work", {})), std::vector<double>{7.0});
  const std::vector<double> all = file.numbers(file.variable("load", {"step", "bump"}));
  const std::vector<double> steps = file.numbers(file.variable("step", {"step"}));
  const std::vector<double> sums = file.numbers(file.variable("torque", {"step"}));
  const std::string csv = folder_.read("results/steps.csv");
  std::string lines = "step,torque_N_m\n";
  for (std::size_t block = 0; block < 500; ++block) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(all[4 * block + k], static_cast<double>(2 * block + k));
    EXPECT_EQ(steps[2 * block + 1], 2.0 * static_cast<double>(block) + 1.0);
    EXPECT_EQ(sums[2 * block], 0.5 * static_cast<double>(block));
    EXPECT_TRUE(std::isnan(sums[2 * block + 1]));
    lines += fmt::format("{},{}\n{},\n", 2 * block, 0.5 * static_cast<double>(block), 2 * block + 1);
  }
  EXPECT_EQ(csv, lines);
}

TEST_F(StagedResultFiles, AreRefusedBeyondTheLimitOfFileSizes) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit low{.rlim_cur = 1'000'000, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &low), 0);
  EXPECT_THROW(stage({}), Error);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
}

}  // namespace
}  // namespace bumpfoil
