#include "experiments/cycle/cycle_outcome.hpp"

#include <gtest/gtest.h>

#include <netcdf>
#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/cycle/increment_rows.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "support/run_files.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

using nlohmann::json;

const CycleResult& filed_run() {
  static const CycleResult result = [] {
    Case input = reference_case();
    CycleSettings& cycle = input.settings.get<CycleSettings>();
    cycle.directions = {0.0};
    cycle.steps = 2;
    return run_cycles(input);
  }();
  return result;
}

std::vector<ResultFile> files_of(const CycleResult& result) {
  return test_support::files_of("cycle", reference_case(), cycle_outcome(reference_case(), result),
                                RunStatus::complete);
}

TEST(CycleFiles, SummaryKnowsTheOthersByTheirChecksums) {
  const std::vector<ResultFile> files = files_of(filed_run());
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].name, "cycle.csv");
  EXPECT_EQ(files[0].contents, csv_text(increment_rows(filed_run())));
  EXPECT_EQ(files[1].name, "result.nc");
  ASSERT_EQ(files[2].name, "summary.json");
  const json summary = json::parse(files[2].contents);
  ASSERT_EQ(summary.at("files").size(), 2U);
  for (const ResultFile& file : {files[0], files[1]}) {
    EXPECT_EQ(summary.at("files").at(file.name).at("bytes"), file.contents.size());
    EXPECT_EQ(summary.at("files").at(file.name).at("xxh3_128"), xxh3_128(file.contents));
  }
}

TEST(CycleFiles, CarryTheSameRunIdAndEveryRunItsOwn) {
  const std::vector<ResultFile> files = files_of(filed_run());
  const std::string run_id = json::parse(files[2].contents).at("run_id");
  EXPECT_EQ(run_id.size(), 32U);
  EXPECT_EQ(run_id.find_first_not_of("0123456789abcdef"), std::string::npos) << run_id;
  const test_support::TemporaryFolder folder;
  const netCDF::NcFile file(folder.write("result.nc", files[1].contents), netCDF::NcFile::read);
  std::string in_netcdf;
  file.getAtt("run_id").getValues(in_netcdf);
  EXPECT_EQ(in_netcdf, run_id);
  EXPECT_NE(json::parse(files_of(filed_run())[2].contents).at("run_id"), run_id);
}

TEST(CycleFiles, OfAStripAreNamedSo) {
  Case input = reference_case();
  input.settings.set(StripSettings{.bumps = 2, .amplitude = {Control::displacement, 1e-6}, .steps = 1});
  EXPECT_EQ(test_support::files_of("strip", input)[0].name, "strip.csv");
}

}  // namespace
}  // namespace bumpfoil
