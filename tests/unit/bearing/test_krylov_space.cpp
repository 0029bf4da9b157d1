#include "bearing/krylov_space.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace bumpfoil {
namespace {

Matrix drawn(Eigen::Index rows, Eigen::Index columns) {
  std::srand(3);
  return Matrix::Random(rows, columns);
}

TEST(KrylovSpace, IsOrthonormalAndMeetsItsEquation) {
  const Matrix C = drawn(30, 30);
  KrylovSpace space(2.5 * Vector::Ones(30), 12);
  while (space.can_grow()) {
    const Eigen::Index m = space.size();
    space.add(C * space.direction());
    ASSERT_EQ(space.size(), m + 1);
    EXPECT_LT((space.basis().transpose() * space.basis() - Matrix::Identity(m + 1, m + 1)).norm(), 1e-13);
    Matrix left = C * space.basis() - space.basis() * space.hessenberg();
    if (space.can_grow()) left.col(m) -= space.next() * space.direction();
    EXPECT_LT(left.leftCols(space.can_grow() ? m + 1 : m).norm(), 1e-13 * C.norm());
  }
  EXPECT_EQ(space.size(), 12);
}

TEST(KrylovSpace, EndsWhereItHoldsAllThatTheOperatorMakesOfIt) {
  Matrix C = Matrix::Zero(4, 4);
  C(1, 0) = C(0, 1) = 1.0;  // couples only the first two directions
  KrylovSpace space(Vector::Unit(4, 0), 4);
  while (space.can_grow()) space.add(C * space.direction());
  EXPECT_EQ(space.size(), 2);
  EXPECT_EQ(space.next(), 0.0);
}

}  // namespace
}  // namespace bumpfoil
