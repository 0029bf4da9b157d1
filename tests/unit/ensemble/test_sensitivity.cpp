#include "bumpfoil/ensemble/sensitivity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace bumpfoil {
namespace {

TEST(Sensitivity, EqualValuesShareTheirRanks) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ranks_of({30.0, 10.0, infinity, 10.0, 20.0, infinity}), (std::vector{4.0, 1.5, 5.5, 1.5, 3.0, 5.5}));
  EXPECT_TRUE(ranks_of({}).empty());
}

TEST(Sensitivity, OfTwoFactorsIsTheClosedForm) {
  const std::vector<double> a{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const std::vector<double> b{2.0, 1.0, 4.0, 3.0, 6.0, 5.0};
  const std::vector<double> y{1.0, 3.0, 2.0, 6.0, 5.0, 4.0};
  // Spearman's 1 - 6 sum d^2 / (n (n^2 - 1)), and (r_ya - r_yb r_ab) / sqrt((1 - r_yb^2) (1 - r_ab^2)).
  const double r_ab = 1.0 - 6.0 * 6.0 / 210.0;
  const double r_ya = 1.0 - 6.0 * 10.0 / 210.0;
  const double r_yb = 1.0 - 6.0 * (1.0 + 4.0 + 4.0 + 9.0 + 1.0 + 1.0) / 210.0;
  const std::vector<double> found = PartialRankCorrelations({a, b}).of(y);
  EXPECT_NEAR(found[0], (r_ya - r_yb * r_ab) / std::sqrt((1.0 - r_yb * r_yb) * (1.0 - r_ab * r_ab)), 1e-14);
  EXPECT_NEAR(found[1], (r_yb - r_ya * r_ab) / std::sqrt((1.0 - r_ya * r_ya) * (1.0 - r_ab * r_ab)), 1e-14);
}

TEST(Sensitivity, SeesWhatMattersHoweverItBends) {
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  constexpr int samples = 2000;
  std::vector<std::vector<double>> factors(3);
  std::vector<double> response;
  for (int i = 0; i < samples; ++i) {
    for (std::vector<double>& factor : factors) factor.push_back(normal(generator));
    response.push_back(std::exp(3.0 * (factors[0].back() - 0.5 * factors[1].back()) + 0.3 * normal(generator)));
  }
  const std::vector<double> found = PartialRankCorrelations(factors).of(response);
  EXPECT_GT(found[0], 0.9);
  EXPECT_LT(found[1], -0.9);
  EXPECT_NEAR(found[2], 0.0, 5.0 / std::sqrt(samples));  // five standard errors
}

TEST(Sensitivity, IsNotDefinedWhereNothingCanBeTold) {
  const std::vector<double> a{1.0, 2.0, 3.0, 4.0, 5.0};
  EXPECT_TRUE(std::isnan(PartialRankCorrelations({a, {2.0, 4.0, 6.0, 8.0, 10.0}}).of(a)[0]));
  EXPECT_TRUE(std::isnan(PartialRankCorrelations({{1.0, 1.0, 1.0, 1.0, 1.0}}).of(a)[0]));
  EXPECT_TRUE(std::isnan(PartialRankCorrelations({a}).of({2.0, 2.0, 2.0, 2.0, 2.0})[0]));
  EXPECT_TRUE(std::isnan(PartialRankCorrelations({{1.0, 2.0, 3.0}}).of({1.0, 3.0, 2.0})[0]));
  EXPECT_EQ(PartialRankCorrelations({a}).of(a)[0], 1.0);
}

}  // namespace
}  // namespace bumpfoil
