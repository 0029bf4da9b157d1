#include "bumpfoil/ensemble/ensemble_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "support/ensemble_cases.hpp"
#include "support/temporary_folder.hpp"

namespace bumpfoil {
namespace {

/// Rows whose numbers encode their position; the second sample failed along -X.
class EnsembleStatisticsOfRows : public ::testing::Test {
 protected:
  EnsembleStatisticsOfRows() {
    std::vector<double> rows;
    for (int sample = 0; sample < 3; ++sample) {
      for (std::size_t place = 0; place < layout_.width(); ++place) {
        rows.push_back(100.0 * static_cast<double>(place) + std::pow(2.0, sample));
      }
      for (const std::size_t direction : {0U, 1U}) {
        rows[static_cast<std::size_t>(sample) * layout_.width() + layout_.entry(direction, 0)] =
            static_cast<double>(sample == 1 && direction == 1 ? Status::no_modes : Status::converged);
      }
    }
    log_.append(rows);
  }

  Case input_{test_support::ensemble_case(3)};
  EnsembleLayout layout_{make_ensemble_layout(input_)};
  test_support::TemporaryFolder folder_;
  RowLog log_{folder_.path() / "log", "", layout_.width()};
};

TEST_F(EnsembleStatisticsOfRows, AreOfTheCyclesThatConverged) {
  const EnsembleStatistics found = make_ensemble_statistics(input_, layout_, log_);
  EXPECT_EQ(found.samples, 3U);
  ASSERT_EQ(found.places.size(), 2U);
  EXPECT_EQ(found.places[0].columns[3].count, 3U);
  EXPECT_DOUBLE_EQ(found.places[0].columns[3].mean, 300.0 + 7.0 / 3.0);
  const auto place = static_cast<double>(layout_.entry(1, 3));
  EXPECT_EQ(found.places[1].columns[3].count, 2U);
  EXPECT_DOUBLE_EQ(found.places[1].columns[3].mean, 100.0 * place + 2.5);
  const auto load = static_cast<double>(layout_.entry(1, layout_.columns.size() + 4));
  EXPECT_DOUBLE_EQ(found.places[1].bump_loads.at(4).mean, 100.0 * load + 2.5);
  EXPECT_EQ(found.places[1].bump_loads.size(), layout_.bumps);
  ASSERT_EQ(found.failures.size(), 1U);
  EXPECT_EQ(found.failures[0].sample, 1U);
  EXPECT_EQ(found.failures[0].place, 1U);
  EXPECT_EQ(layout_.status_name(found.failures[0].status), "no_modes");
}

TEST_F(EnsembleStatisticsOfRows, SensitivitiesAreToFactorsOfTheSamplesThatConverged) {
  input_.montecarlo = MonteCarloSettings{.friction_top_bump = Distribution{.sigma = 0.01},
                                         .radial_clearance = Distribution{.sigma = 1e-6}};
  RowLog log(folder_.path() / "drawn", "", layout_.width());
  for (std::uint64_t i = 0; i < 50; ++i) {
    std::vector<double> row(layout_.width(), 0.0);
    const Sample sample = draw_sample(input_, i);
    for (const std::size_t direction : {0U, 1U}) {
      row[layout_.entry(direction, 1)] = -std::exp(100.0 * sample.deviations[3]) + (i == 7 ? 1e9 : 0.0);
      row[layout_.entry(direction, 0)] = static_cast<double>(i == 7 ? Status::no_modes : Status::converged);
    }
    log.append(row);
  }
  const std::vector<std::vector<double>> found = make_ensemble_statistics(input_, layout_, log).places[1].sensitivities;
  ASSERT_EQ(found[1].size(), 2U);
  EXPECT_NEAR(found[1][0], -1.0, 1e-7);  // decreases monotonically; square root of round-off
  EXPECT_NEAR(found[1][1], 0.0, 0.72);   // five standard errors, 1 / sqrt(48)
  EXPECT_TRUE(std::isnan(found[2][0]));  // constant
}

TEST_F(EnsembleStatisticsOfRows, ErrorOfTheForceIsTheLargestOfAllDirections) {
  ASSERT_EQ(layout_.columns[1].meaning.name, "max_force");
  // Values 101, 102, 104, and place + 1, place + 4.
  const auto place = static_cast<double>(layout_.entry(1, 1));
  const double first = std::sqrt(7.0 / 9.0) / (100.0 + 7.0 / 3.0);
  const double second = 1.5 / (100.0 * place + 2.5);
  EXPECT_NEAR(relative_error_of_mean(layout_, log_), std::max(first, second), 1e-15);
  const RowLog empty(folder_.path() / "empty", "", layout_.width());
  EXPECT_TRUE(std::isnan(relative_error_of_mean(layout_, empty)));
}

}  // namespace
}  // namespace bumpfoil
