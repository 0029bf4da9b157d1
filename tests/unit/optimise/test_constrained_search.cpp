#include "optimise/constrained_search.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace bumpfoil {
namespace {

const Eigen::VectorXd middle_of_box = Eigen::VectorXd::Constant(2, 0.5);

/// A quadratic function whose minimum, (0.3, 0.8), violates a limit: x + y <= 1.
bool bowl(const Eigen::VectorXd& x, double& aim, Eigen::VectorXd& limits) {
  aim = (x - Eigen::Vector2d(0.3, 0.8)).squaredNorm();
  limits[0] = x.sum() - 1.0;
  return true;
}

TEST(ConstrainedSearch, EndsByItsToleranceAtTheLimit) {
  Eigen::VectorXd last;
  const SearchProblem problem{1, [&last](const auto& x, double& aim, Eigen::VectorXd& limits) {
                                last = x;
                                return bowl(x, aim, limits);
                              }};
  EXPECT_EQ(search_constrained(problem, middle_of_box, 0.25, 1e-4), SearchEnd::tolerance);
  EXPECT_NEAR(last[0], 0.25, 1e-3);
  EXPECT_NEAR(last[1], 0.75, 1e-3);
}

TEST(ConstrainedSearch, StopsWhereTheFunctionDoes) {
  int calls = 0;
  const SearchProblem problem{
      1, [&calls](const auto& x, double& aim, Eigen::VectorXd& limits) { return ++calls < 5 && bowl(x, aim, limits); }};
  EXPECT_EQ(search_constrained(problem, middle_of_box, 0.25, 1e-4), SearchEnd::stopped);
  EXPECT_EQ(calls, 5);
}

/// Without a tolerance steps shrink down to round-off.
TEST(ConstrainedSearch, SaysWhereRoundOffEndsIt) {
  EXPECT_EQ(search_constrained({1, bowl}, middle_of_box, 0.25, 0.0), SearchEnd::round_off);
}

struct OwnError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Exceptions of the function pass through the C code of NLopt unchanged.
TEST(ConstrainedSearch, PassesOnWhatTheFunctionThrows) {
  const auto throws = [](const auto&, double&, auto&) -> bool { throw OwnError("of the function"); };
  EXPECT_THROW(search_constrained({1, throws}, middle_of_box, 0.25, 1e-4), OwnError);
  EXPECT_THROW(search_constrained({1, [](const auto&, double&, auto&) -> bool { throw std::bad_alloc(); }},
                                  middle_of_box, 0.25, 1e-4),
               std::bad_alloc);
}

/// NLopt rejects a start outside the box, with its own message.
TEST(ConstrainedSearch, ThrowsWhatNloptRefuses) {
  try {
    static_cast<void>(search_constrained({1, bowl}, Eigen::VectorXd::Constant(2, 1.5), 0.25, 1e-4));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("NLopt: ")) << error.what();
    EXPECT_GT(std::string(error.what()).size(), 8U);
  }
}

}  // namespace
}  // namespace bumpfoil
