#include "bumpfoil/core/block_tridiagonal.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

BlockTridiagonal example() {
  BlockTridiagonal K(3, 2);
  K.add(0, 0, 0, 0, 4.0);
  K.add(0, 0, 0, 1, -1.0);
  K.add(0, 1, 1, 0, 2.0);
  K.add(2, 1, 1, 1, 5.0);  // below the diagonal: stored transposed
  K.add(2, 0, 2, 0, 7.0);
  return K;
}

TEST(BlockTridiagonal, WritesOutASymmetricMatrix) {
  const Matrix K = example().dense();
  EXPECT_EQ(K, K.transpose());
  EXPECT_EQ(K(0, 0), 4.0);
  EXPECT_EQ(K(0, 1), -1.0);
  EXPECT_EQ(K(1, 2), 2.0);
  EXPECT_EQ(K(5, 3), 5.0);
  EXPECT_EQ(K(4, 4), 7.0);
}

TEST(BlockTridiagonal, MultipliesLikeItsDenseForm) {
  const BlockTridiagonal K = example();
  const Vector x = Vector::LinSpaced(6, 1.0, 6.0);
  EXPECT_EQ(K.multiply(x), K.dense() * x);  // small integers: exact
}

TEST(BlockTridiagonal, MayBeUnsymmetric) {
  for (const int size : {2, 6}) {  // generic and compiled sizes
    BlockTridiagonal K(3, size);
    for (Matrix& block : K.diagonal) block.setConstant(2.0);
    for (Matrix& block : K.upper) block.setConstant(3.0);
    EXPECT_TRUE(K.is_symmetric());
    K.lower.assign(2, Matrix::Constant(size, size, 5.0));
    EXPECT_FALSE(K.is_symmetric());
    EXPECT_EQ(K.dense()(0, size), 3.0);
    EXPECT_EQ(K.dense()(size, 0), 5.0);
    const Vector x = Vector::LinSpaced(3 * size, 1.0, 3.0 * size);
    EXPECT_EQ(K.multiply(x), K.dense() * x);  // small integers: exact
  }
}

TEST(BlockTridiagonal, TakesTheBlocksOfAnother) {
  BlockTridiagonal first(2, 2);
  first.add(0, 0, 1, 1, 3.0);
  first.add(1, 0, 1, 0, 5.0);
  BlockTridiagonal second(1, 2);
  second.add(0, 0, 0, 1, 7.0);
  Matrix expected = Matrix::Zero(6, 6);
  expected.topLeftCorner(4, 4) = first.dense();
  expected.bottomRightCorner(2, 2) = second.dense();
  first.append(second);
  EXPECT_EQ(first.dense(), expected);
}

TEST(BlockTridiagonal, SingleBlockAndEmpty) {
  EXPECT_EQ(BlockTridiagonal(1, 3).rows(), 3);
  EXPECT_EQ(BlockTridiagonal().rows(), 0);
}

}  // namespace
}  // namespace bumpfoil
