#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "bumpfoil/ensemble/ensemble_files.hpp"
#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/ensemble/ensemble_run.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "model/case_table.hpp"
#include "support/ensemble_cases.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil::test_support {

/// Results of an ensemble of four bearings; the last one failed.
class EnsembleFiles : public ::testing::Test {
 protected:
  EnsembleFiles() {
    std::vector<double> rows;
    for (std::uint64_t i = 0; i < 4; ++i) {
      // The last one is an invalid sample.
      const std::vector<double> row = i < 3
                                          ? EnsembleSampler(input_, layout_).run(i, [](double) { return true; }).value()
                                          : make_ensemble_row(layout_, std::nullopt);
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

  Case input_ = [] {
    Case input = ensemble_case(4);
    input.solver.name = ensemble_solver(input);
    return input;
  }();
  EnsembleLayout layout_{make_ensemble_layout(input_)};
  TemporaryFolder folder_;
  RowLog log_{folder_.path() / "log", "", layout_.width()};
  std::filesystem::path netcdf_{folder_.path() / "results" / "ensemble.nc"};
};

}  // namespace bumpfoil::test_support
