#include "bumpfoil/io/ensemble_layout.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "bumpfoil/ensemble/sample.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

TEST(EnsembleLayout, RowsHoldTheQuantitiesOfEveryCycle) {
  Case input = testing::ensemble_case(1);
  input.cycle.clearance_forces = {5.0, 1e6};
  const EnsembleLayout layout = make_ensemble_layout(input);
  EXPECT_EQ(layout.columns.front().name, "status");
  std::set<std::string> names;
  for (const EnsembleColumn& column : layout.columns) names.insert(column.name);
  EXPECT_EQ(names.size(), layout.columns.size());
  EXPECT_EQ(names.count("clearance_5N"), 1U);
  EXPECT_EQ(names.count("clearance_1e+06N"), 1U);

  const Case sampled = sampled_case(input, draw_sample(input, 0));
  const CycleResult result = run_sample(sampled);
  const std::vector<double> row = make_ensemble_row(layout, sampled, result);
  ASSERT_EQ(row.size(), layout.width());
  for (std::size_t direction = 0; direction < 2; ++direction) {
    const Cycle& cycle = result.cycles[direction];
    const auto value = [&](std::string_view name) -> double {
      for (std::size_t k = 0; k < layout.columns.size(); ++k) {
        if (layout.columns[k].name == name) return row[layout.place(direction, k)];
      }
      return NAN;
    };
    EXPECT_EQ(value("status"), 0.0);
    EXPECT_EQ(value("max_force"), cycle.turning_point->max_force);
    EXPECT_EQ(value("loop_energy"), *cycle.loop_energy);
    EXPECT_EQ(value("clearance_5N"), *cycle.clearance_5N);
    EXPECT_TRUE(std::isnan(value("clearance_1e+06N")));
    EXPECT_EQ(value("largest_bump_load"), cycle.turning_point->bump_loads.maxCoeff());
    EXPECT_EQ(row[layout.place(direction, layout.columns.size() + 7)], cycle.turning_point->bump_loads[7]);
  }
}

TEST(EnsembleLayout, OfWhatWasNotRunOnlyTheStatusIsKnown) {
  const Case input = testing::ensemble_case(1);
  Case sampled = input;
  sampled.friction.top_bump = -0.1;
  const EnsembleLayout layout = make_ensemble_layout(input);
  const std::vector<double> row = make_ensemble_row(layout, sampled, run_sample(sampled));
  for (std::size_t k = 0; k < layout.per_cycle(); ++k) {
    if (k == 0) {
      EXPECT_EQ(row[k], static_cast<double>(Status::not_physical));
    } else {
      EXPECT_TRUE(std::isnan(row[k])) << k;
    }
  }
}

}  // namespace
}  // namespace bumpfoil
