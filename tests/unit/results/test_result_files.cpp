#include "results/result_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
    stage_result_files({.input = input_,
                        .command = "montecarlo",
                        .status = RunStatus::complete,
                        .message = "",
                        .provenance = provenance},
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
    EXPECT_NE(std::string(error.what()).find("numbers.nc: takes up to"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bumpfoil
