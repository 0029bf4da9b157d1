#include "experiments/fit/least_squares.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace bumpfoil {
namespace {

const auto never_stops = [] { return true; };

/// A datum at 0.2 with a linear loss beyond 1, and a prior at 0.9 without.
LeastSquares datum_and_prior() {
  const auto residuals = [](const Eigen::VectorXd& x) -> std::optional<Eigen::VectorXd> {
    return Eigen::Vector2d(100.0 * (x[0] - 0.2), 10.0 * (x[0] - 0.9));
  };
  return {.residuals = residuals, .robust = 1, .huber = 1.0};
}

TEST(LeastSquares, PriorsCountByTheirSquaresUnderHubersLoss) {
  const LeastSquares problem = datum_and_prior();
  EXPECT_NEAR(cost_of(problem, Eigen::Vector2d(-5.0, 3.0)), (2.0 * 5.0 - 1.0) + 9.0, 1e-12);
  EXPECT_NEAR(cost_of(problem, Eigen::Vector2d(0.5, -3.0)), 0.25 + 9.0, 1e-12);
  const auto minimum = minimise(problem, Eigen::VectorXd::Constant(1, 0.5), never_stops);
  ASSERT_TRUE(minimum);
  // 100^2 (x - 0.2) = 10^2 (0.9 - x): the datum is within 1, the prior at 6.9.
  EXPECT_NEAR(minimum->x[0], (1e4 * 0.2 + 1e2 * 0.9) / (1e4 + 1e2), 1e-5);
  EXPECT_NEAR(minimum->cost, minimum->residuals.squaredNorm(), 1e-9);
}

TEST(LeastSquares, ConvergeUnlessTheyAreStopped) {
  const LeastSquares problem = datum_and_prior();
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(1, 0.5);
  EXPECT_TRUE(minimise(problem, start, never_stops)->converged);
  EXPECT_FALSE(minimise(problem, start, [] { return false; })->converged);
}

TEST(LeastSquares, TellJumpsFromSlopesAndKinks) {
  const auto bend_of = [](const auto& residual) {
    const LeastSquares problem{.residuals = [&residual](const Eigen::VectorXd& x) -> std::optional<Eigen::VectorXd> {
      return Eigen::VectorXd::Constant(1, residual(x[0]));
    }};
    const Eigen::VectorXd x = Eigen::VectorXd::Constant(1, 0.5);
    return differences_at(problem, x, *problem.residuals(x))->bends[0];
  };
  EXPECT_LT(bend_of([](double x) { return std::exp(3.0 * x); }), 2e-3);  // h f''/f' / 1
  EXPECT_NEAR(bend_of([](double x) { return x > 0.5 ? 2.0 * x : x + 0.5; }), 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(bend_of([](double x) { return x + (x > 0.5 ? 1.0 : 0.0); }), 1.0, 3e-3);
  EXPECT_EQ(bend_of([](double /*x*/) { return 3.0; }), 0.0);
}

}  // namespace
}  // namespace bumpfoil
