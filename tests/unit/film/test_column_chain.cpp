#include "film/column_chain.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace bumpfoil {
namespace {

/// A well-posed chain without zeros.
std::unique_ptr<ColumnChain> example_chain(int columns, int size) {
  auto chain = make_column_chain(columns, size);
  for (int c = 0; c < columns; ++c) {
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) {
        chain->lower(c)(i, j) = std::sin(1.0 + c + 3 * i + 7 * j);
        chain->upper(c)(i, j) = std::cos(2.0 + 2 * c + 5 * i + j);
        chain->diagonal(c)(i, j) = std::sin(3.0 * c + i * j) + (i == j ? 5.0 * size : 0.0);
      }
    }
  }
  return chain;
}

/// The chain with the columns of both neighbours as a dense matrix, the chain in the middle.
Matrix dense(ColumnChain& chain) {
  const Eigen::Index n = chain.block_size();
  Matrix A = Matrix::Zero(n * chain.columns(), n * (chain.columns() + 2));
  for (int c = 0; c < chain.columns(); ++c) {
    A.block(c * n, c * n, n, n) = chain.lower(c);
    A.block(c * n, (c + 1) * n, n, n) = chain.diagonal(c);
    A.block(c * n, (c + 2) * n, n, n) = chain.upper(c);
  }
  return A;
}

TEST(ColumnChain, SolvesAndAnswersItsNeighboursLikeADenseMatrix) {
  for (const int size : {1, 3, 8, 10, 16, 18}) {  // compiled and generic sizes
    for (const int columns : {1, 2, 6}) {
      const auto chain = example_chain(columns, size);
      const Eigen::Index n = size;
      ASSERT_TRUE(chain->factor());
      const Matrix A = dense(*chain);
      const auto own = A.middleCols(n, n * columns).partialPivLu();
      const Vector right = Vector::LinSpaced(n * columns, -1.0, 2.0);
      Vector x = right;
      chain->solve_in_place(x);
      // All matrices of the example have condition numbers near 1.
      EXPECT_LT((x - own.solve(right)).cwiseAbs().maxCoeff(), 1e-14) << size << ' ' << columns;

      ColumnChain::Response before, after;
      chain->respond(before, after);
      const Matrix to_before = own.solve(A.leftCols(n));
      const Matrix to_after = own.solve(A.rightCols(n));
      EXPECT_LT((before.first - to_before.topRows(n)).cwiseAbs().maxCoeff(), 1e-14);
      EXPECT_LT((before.last - to_before.bottomRows(n)).cwiseAbs().maxCoeff(), 1e-14);
      EXPECT_LT((after.first - to_after.topRows(n)).cwiseAbs().maxCoeff(), 1e-14);
      EXPECT_LT((after.last - to_after.bottomRows(n)).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST(ColumnChain, ReportsSingularEquations) {
  const auto chain = example_chain(4, 3);
  chain->lower(2).row(1).setZero();
  chain->diagonal(2).row(1).setZero();
  chain->upper(2).row(1).setZero();
  EXPECT_FALSE(chain->factor());
}

}  // namespace
}  // namespace bumpfoil
