#include "bumpfoil/core/block_tridiagonal_lu.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// An unsymmetric matrix with a full band, with diagonal blocks dominant enough for pivoting within the blocks.
template <int B>
BlockTridiagonalLU<B> factored_example(int blocks, int size,
                                       VectorInstructions instructions = widest_vector_instructions()) {
  BlockTridiagonalLU<B> lu(blocks, size, instructions);
  for (int b = 0; b < blocks; ++b) {
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) {
        lu.lower(b)(i, j) = std::sin(1.0 + b + 3 * i + 7 * j);
        lu.upper(b)(i, j) = std::cos(2.0 + 2 * b + 5 * i + j);
        // Largest next to the diagonal: without row exchanges inside the block the pivots would be poor.
        lu.diagonal(b)(i, j) = std::sin(3.0 * b + i * j) + (j == (i + 1) % size ? 4.0 * size : 0.0);
      }
    }
  }
  return lu;
}

template <int B>
Matrix dense(BlockTridiagonalLU<B>& lu, int size) {
  const Eigen::Index n = Eigen::Index{lu.blocks()} * size;
  Matrix A = Matrix::Zero(n, n);
  for (int b = 0; b < lu.blocks(); ++b) {
    const Eigen::Index row = Eigen::Index{b} * size;
    A.block(row, row, size, size) = lu.diagonal(b);
    if (b > 0) A.block(row, row - size, size, size) = lu.lower(b);
    if (b + 1 < lu.blocks()) A.block(row, row + size, size, size) = lu.upper(b);
  }
  return A;
}

template <int B>
void expect_solves_like_dense(BlockTridiagonalLU<B>& lu, int size) {
  const Matrix A = dense(lu, size);
  const Vector right = Vector::LinSpaced(A.rows(), -1.0, 2.0);
  const Vector expected = solve(A, right);
  Vector x = right;
  lu.solve_in_place(x);
  EXPECT_LT((x - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());  // well conditioned
}

TEST(BlockTridiagonalLU, SolvesLikeADenseMatrixOfFixedBlocks) {
  for (const int blocks : {1, 2, 3, 40}) {
    auto lu = factored_example<6>(blocks, 6);
    ASSERT_TRUE(lu.factor());
    expect_solves_like_dense(lu, 6);
  }
}

TEST(BlockTridiagonalLU, SolvesLikeADenseMatrixOfBlocksOfAnySize) {
  for (const int size : {1, 2, 5, 11}) {
    auto lu = factored_example<Eigen::Dynamic>(7, size);
    ASSERT_TRUE(lu.factor());
    expect_solves_like_dense(lu, size);
  }
}

TEST(BlockTridiagonalLU, SolvesLargeBlocksWithEachOfTheInstructionsOfThisProcessor) {
  for (const VectorInstructions instructions : vector_instructions()) {
    SCOPED_TRACE(name_of(instructions));
    auto fixed = factored_example<22>(7, 22, instructions);
    ASSERT_TRUE(fixed.factor());
    expect_solves_like_dense(fixed, 22);
    auto any = factored_example<Eigen::Dynamic>(7, 13, instructions);
    ASSERT_TRUE(any.factor());
    expect_solves_like_dense(any, 13);
  }
}

TEST(BlockTridiagonalLU, FactorsAgainFromTheFirstChangedBlock) {
  auto lu = factored_example<6>(10, 6);
  ASSERT_TRUE(lu.factor());
  lu.diagonal(4)(2, 3) += 5.0;
  lu.lower(4)(0, 0) -= 1.0;
  lu.upper(4)(5, 1) += 2.0;
  lu.diagonal(8)(0, 0) += 1.0;
  ASSERT_TRUE(lu.factor(4));
  expect_solves_like_dense(lu, 6);
}

TEST(BlockTridiagonalLU, SolvesForManyRightHandSidesAtOnce) {
  const auto check = [](auto lu) {
    ASSERT_TRUE(lu.factor());
    RowMajorMatrix panel(24, 7);
    for (Eigen::Index i = 0; i < panel.size(); ++i) panel.data()[i] = std::sin(static_cast<double>(i * i));
    const Matrix right = panel;
    lu.solve_panel_in_place(panel);
    for (Eigen::Index c = 0; c < right.cols(); ++c) {
      Vector x = right.col(c);
      lu.solve_in_place(x);
      EXPECT_LT((panel.col(c) - x).norm(), 1e-13 * x.norm());
    }
  };
  check(factored_example<6>(4, 6));
  check(factored_example<8>(3, 8));
  check(factored_example<Eigen::Dynamic>(6, 4));
}

TEST(BlockTridiagonalLU, SolvesForRightHandSidesOfOneBlock) {
  auto lu = factored_example<6>(9, 6);
  ASSERT_TRUE(lu.factor());
  const Matrix A = dense(lu, 6);
  using Block = BlockTridiagonalLU<6>::Block;
  const Block right = lu.diagonal(3);
  std::vector<Block> solution(9, Block::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (const int block : {0, 4, 8}) {
    lu.solve_block_column(block, right, solution);
    Matrix whole = Matrix::Zero(54, 6);
    whole.middleRows(6 * block, 6) = right;
    const Matrix expected = solve(A, whole);
    for (int b = 0; b < 9; ++b) {
      EXPECT_LT((solution[static_cast<std::size_t>(b)] - expected.middleRows(6 * b, 6)).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST(BlockTridiagonalLU, DoesNotReadBlocksOutsideTheMatrix) {
  auto lu = factored_example<Eigen::Dynamic>(3, 2);
  lu.lower(0).setConstant(std::numeric_limits<double>::infinity());
  lu.upper(2).setConstant(std::numeric_limits<double>::infinity());
  ASSERT_TRUE(lu.factor());
  expect_solves_like_dense(lu, 2);
}

TEST(BlockTridiagonalLU, ReportsSingularAndBrokenMatrices) {
  auto singular = factored_example<6>(4, 6);
  singular.lower(2).row(3).setZero();
  singular.diagonal(2).row(3).setZero();
  singular.upper(2).row(3).setZero();
  EXPECT_FALSE(singular.factor());

  auto broken = factored_example<6>(4, 6);
  broken.diagonal(1)(4, 4) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(broken.factor());

  auto endless = factored_example<6>(4, 6);
  endless.diagonal(3).setConstant(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(endless.factor());
}

}  // namespace
}  // namespace bumpfoil
