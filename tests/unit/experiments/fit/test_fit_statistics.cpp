#include "experiments/fit/fit_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bumpfoil {
namespace {

TEST(FitStatistics, KnowStudentsT) {
  EXPECT_NEAR(student_975(5), 2.5706, 3e-3);  // from tables, two-sided 5 %
  EXPECT_NEAR(student_975(10), 2.2281, 1e-3);
  EXPECT_NEAR(student_975(30), 2.0423, 1e-4);
  EXPECT_NEAR(student_975(100000), 1.95996, 1e-4);
}

TEST(FitStatistics, CallChiSquareExcessiveBeyondFourDeviations) {
  // Chi-square with 100 degrees of freedom has an upper tail of 3.2e-5 at 166.
  EXPECT_FALSE(is_excessive(164.0, 100));
  EXPECT_TRUE(is_excessive(168.0, 100));
}

TEST(FitStatistics, GiveTheCovarianceOfALine) {
  // A line through 0, 1, 2, 3 with variance 1: the variance of the slope is 1 / sum (x - mean)^2.
  Eigen::MatrixXd line(4, 2);
  line << 1, 0, 1, 1, 1, 2, 1, 3;
  const FitEstimate estimate{line, Eigen::VectorXd::Ones(4), Eigen::VectorXd::Ones(4), {false, false}};
  const Eigen::MatrixXd covariance = covariance_of(estimate);
  EXPECT_NEAR(covariance(1, 1), 1.0 / 5.0, 1e-14);
  EXPECT_NEAR(covariance(0, 0), 1.0 / 4.0 + 1.5 * 1.5 / 5.0, 1e-14);
  EXPECT_NEAR(covariance(0, 1), -1.5 / 5.0, 1e-14);
}

TEST(FitStatistics, DoNotKnowWhatIsHeldOrNotTold) {
  Eigen::MatrixXd sensitivities(3, 3);
  sensitivities << 1, 0, 1, 2, 1, 2, 3, 0, 3;  // the first and the last have the same effect
  FitEstimate estimate{sensitivities, Eigen::VectorXd::Ones(3), Eigen::VectorXd::Ones(3), {false, false, false}};
  Eigen::MatrixXd covariance = covariance_of(estimate);
  EXPECT_TRUE(std::isnan(covariance(0, 0)));
  EXPECT_TRUE(std::isnan(covariance(2, 2)));
  EXPECT_TRUE(std::isfinite(covariance(1, 1)));
  estimate.held[2] = true;
  covariance = covariance_of(estimate);
  EXPECT_TRUE(std::isfinite(covariance(0, 0)));
  EXPECT_TRUE(std::isnan(covariance(2, 2)));
}

TEST(FitStatistics, NameWhatIsHardlyTold) {
  const std::vector<FitParameter> parameters{{.key = "a", .start = 1, .lower = 0, .upper = 2},
                                             {.key = "b", .start = 1, .lower = 0, .upper = 2},
                                             {.key = "c", .start = 1, .lower = 0, .upper = 2}};
  Eigen::MatrixXd sensitivities(3, 3);
  sensitivities << 1, 1, 0, 2, 2, 0, 0, 0.1, 0;
  double collinearity = 0.0;
  std::vector<std::string> lines = hardly_told(sensitivities, parameters, {"m", "m", "1"}, collinearity);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "c does not change the data");
  EXPECT_EQ(lines[1], "a and b: only their sum can be identified");
  EXPECT_GT(collinearity, 10.0);
  sensitivities.col(1) *= -1.0;
  EXPECT_EQ(hardly_told(sensitivities, parameters, {"m", "m", "1"}, collinearity)[1],
            "a and b: only their difference can be identified");
  sensitivities.col(1) *= 3.0;
  EXPECT_EQ(hardly_told(sensitivities, parameters, {"m", "N", "1"}, collinearity)[1],
            "a and b are hardly separable: +0.02 m of one makes up for +0.00666 N of the other");
  sensitivities << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  EXPECT_TRUE(hardly_told(sensitivities, parameters, {"m", "N", "1"}, collinearity).empty());
  EXPECT_NEAR(collinearity, 1.0, 1e-12);
}

}  // namespace
}  // namespace bumpfoil
