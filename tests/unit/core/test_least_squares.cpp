#include "core/least_squares.hpp"

#include <gtest/gtest.h>

#include <initializer_list>

namespace bumpfoil {
namespace {

constexpr double round_off = 1e-14;  // of numbers about one

Eigen::VectorXd numbers(std::initializer_list<double> values) {
  return Eigen::VectorXd::Map(values.begin(), static_cast<Eigen::Index>(values.size()));
}

TEST(LeastSquares, FitsALineToPointsBesideIt) {
  Eigen::MatrixXd A(3, 2);
  A << 1, 0, 1, 1, 1, 2;
  // About y = 1 + 2 x: the residual 1, -2, 1 is orthogonal to both columns.
  EXPECT_LT((least_squares(A, numbers({2, 1, 6})) - numbers({1, 2})).norm(), round_off);
}

TEST(LeastSquares, GivesTheShortestOfSeveral) {
  Eigen::MatrixXd A(2, 3);
  A << 1, 1, 0, 2, 2, 0;
  Eigen::MatrixXd B(2, 2);
  B << 2, 4, 4, 8;
  Eigen::MatrixXd expected(3, 2);
  expected << 1, 2, 1, 2, 0, 0;
  EXPECT_LT((least_squares(A, B) - expected).norm(), round_off);
}

TEST(LeastSquares, TakesSmallPivotsForZero) {
  const Eigen::MatrixXd A = numbers({1, 1e-6}).asDiagonal();
  EXPECT_LT((least_squares(A, numbers({1, 1})) - numbers({1, 1e6})).norm(), 1e-6);  // round-off of 1e6
  EXPECT_LT((least_squares(A, numbers({1, 1}), 1e-5) - numbers({1, 0})).norm(), round_off);
}

}  // namespace
}  // namespace bumpfoil
