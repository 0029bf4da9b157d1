#include "bumpfoil/ensemble/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bumpfoil {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Statistics, OfAHandfulAreThoseOfHand) {
  const Statistics found = statistics_of({4.0, 1.0, nan, 3.0, 2.0, 10.0});
  EXPECT_EQ(found.count, 5U);
  EXPECT_EQ(found.undefined, 1U);
  EXPECT_DOUBLE_EQ(found.mean, 4.0);
  EXPECT_DOUBLE_EQ(found.deviation, std::sqrt(50.0 / 4.0));
  EXPECT_DOUBLE_EQ(found.standard_error, std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(found.mean_low, 4.0 - 1.959963984540054 * std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(found.mean_high, 4.0 + 1.959963984540054 * std::sqrt(2.5));
  EXPECT_DOUBLE_EQ(found.percentile[3], 3.0);
  EXPECT_DOUBLE_EQ(found.percentile[2], 2.0);
  EXPECT_DOUBLE_EQ(found.percentile[4], 4.0);
  EXPECT_DOUBLE_EQ(found.percentile[5], 4.0 + 0.8 * 6.0);  // same as numpy.percentile
}

TEST(Statistics, WhatIsNotReachedIsLargestInPercentilesAndInNoMean) {
  const Statistics found = statistics_of({1.0, nan, 3.0, nan, 2.0}, Undefined::largest);
  EXPECT_EQ(found.count, 3U);
  EXPECT_EQ(found.undefined, 2U);
  EXPECT_DOUBLE_EQ(found.mean, 2.0);
  EXPECT_DOUBLE_EQ(found.percentile[2], 2.0);
  EXPECT_DOUBLE_EQ(found.percentile[3], 3.0);
  EXPECT_TRUE(std::isnan(found.percentile[4]));
}

TEST(Statistics, DoNotDependOnTheOrder) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(std::sin(1.0 + i * i));
  const Statistics one = statistics_of(values);
  const Statistics other = statistics_of({values.rbegin(), values.rend()});
  EXPECT_EQ(one.mean, other.mean);
  EXPECT_EQ(one.deviation, other.deviation);
}

TEST(Statistics, OfTooFewAreNotDefined) {
  EXPECT_TRUE(std::isnan(statistics_of({}).mean));
  EXPECT_TRUE(std::isnan(statistics_of({nan}).percentile[3]));
  const Statistics one = statistics_of({2.0});
  EXPECT_EQ(one.mean, 2.0);
  EXPECT_EQ(one.percentile[0], 2.0);
  EXPECT_TRUE(std::isnan(one.deviation));
  EXPECT_TRUE(std::isnan(one.mean_low));
}

}  // namespace
}  // namespace bumpfoil
