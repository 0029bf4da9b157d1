#include "bumpfoil/results/dataset.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bumpfoil {
namespace {

TEST(Dataset, CountsTheNumbersOfAVariable) {
  Dataset data;
  data.add_dimension({"load", "1", "load"}, {1.0, 2.0});
  data.add_dimension({"pad", "1", "pad"}, {1.0, 2.0, 3.0});
  const Variable& force = data.add({"force", "N", "force"}, {"load", "pad"}, std::vector<double>(6, 1.0));
  EXPECT_EQ(data.size_of("pad"), 3U);
  EXPECT_EQ(data.size_of(force), 6U);
  EXPECT_EQ(force.values().size(), 6U);
  ASSERT_EQ(data.coordinates.size(), 2U);
  EXPECT_TRUE(data.coordinates[0].known);
  EXPECT_EQ(data.coordinates[1].dims, std::vector<std::string>{"pad"});
  EXPECT_EQ(data.size_of(data.add({"count", "1", "a scalar"}, {}, std::vector<double>{7.0})), 1U);
}

TEST(Dataset, ReadsValuesWhenTheyAreNeeded) {
  double number = 1.0;
  Dataset data;
  data.add({"x", "m", "x"}, {}, [&number] { return std::vector<double>{number}; });
  number = 2.0;
  EXPECT_EQ(data.variables[0].values(), std::vector<double>{2.0});
}

TEST(Dataset, FillsRowsUpWithAbsentNumbers) {
  const std::vector<std::vector<double>> rows{{1.0}, {}, {2.0, 3.0}};
  const std::vector<double> all = padded_rows(rows.size(), 2, [&](std::size_t i) { return rows[i]; });
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(all[0], 1.0);
  for (const std::size_t i : {1U, 2U, 3U}) EXPECT_TRUE(std::isnan(all[i])) << i;
  EXPECT_EQ(all[4], 2.0);
  EXPECT_EQ(all[5], 3.0);
}

}  // namespace
}  // namespace bumpfoil
