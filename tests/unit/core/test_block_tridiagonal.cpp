#include "bumpfoil/core/block_tridiagonal.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

BlockTridiagonal example() {
  BlockTridiagonal K(3, 2);
  K.add(0, 0, 0, 0, 4.0);
  K.add(0, 0, 0, 1, -1.0);
  K.add(0, 1, 1, 0, 2.0);
  K.add(2, 1, 1, 1, 5.0);  // given below the diagonal: stored mirrored
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

TEST(BlockTridiagonal, SingleBlockAndEmpty) {
  EXPECT_EQ(BlockTridiagonal(1, 3).rows(), 3);
  EXPECT_EQ(BlockTridiagonal().rows(), 0);
}

}  // namespace
}  // namespace bumpfoil
