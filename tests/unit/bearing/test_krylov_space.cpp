#include "bearing/krylov_space.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace bumpfoil {
namespace {

Matrix drawn(Eigen::Index rows, Eigen::Index columns) {
  std::srand(3);
  return Matrix::Random(rows, columns);
}

void expect_orthonormal_and_exact(const Matrix& C, const Matrix& starts, KrylovSpace& space) {
  EXPECT_LT((space.next().leftCols(space.start().rows()) * space.start() - starts).norm(), 1e-13 * starts.norm());
  while (space.can_grow()) {
    const Eigen::Index m = space.size();
    space.add(C * space.next().col(0));
    ASSERT_EQ(space.size(), m + 1);
    Matrix all(C.rows(), m + 1 + space.next().cols());
    all << space.basis(), space.next();
    EXPECT_LT((all.transpose() * all - Matrix::Identity(all.cols(), all.cols())).norm(), 1e-13);
    const Matrix left = C * space.basis() - space.basis() * space.hessenberg() - space.next() * space.into_next();
    EXPECT_LT(left.norm(), 1e-13 * C.norm());
  }
}

TEST(KrylovSpace, IsOrthonormalAndMeetsItsEquation) {
  const Matrix C = drawn(30, 30);
  const Matrix start = 2.5 * Vector::Ones(30);
  KrylovSpace space(start, 12);
  expect_orthonormal_and_exact(C, start, space);
  EXPECT_EQ(space.size(), 12);
}

TEST(KrylovSpace, OfSeveralVectorsGrowsFromAll) {
  const Matrix C = drawn(30, 30);
  const Matrix starts = drawn(30, 5).rightCols(3);
  KrylovSpace space(starts, 12);
  expect_orthonormal_and_exact(C, starts, space);
  EXPECT_EQ(space.next().cols(), 3);
  EXPECT_EQ(space.start_of_all().topRows(3), space.start());
}

TEST(KrylovSpace, HoldsAStartThatIsASumOfOthersAlready) {
  const Matrix C = drawn(30, 30);
  Matrix starts = drawn(30, 3);
  starts.col(1) = -2.0 * starts.col(0);
  KrylovSpace space(starts, 12);
  EXPECT_EQ(space.next().cols(), 2);
  expect_orthonormal_and_exact(C, starts, space);
}

TEST(KrylovSpace, EndsWhereItHoldsAllThatTheOperatorMakesOfIt) {
  Matrix C = Matrix::Zero(4, 4);
  C(1, 0) = C(0, 1) = 1.0;  // the first two directions alone
  KrylovSpace space(Vector::Unit(4, 0), 4);
  while (space.can_grow()) space.add(C * space.next());
  EXPECT_EQ(space.size(), 2);
  EXPECT_EQ(space.next().cols(), 0);
}

}  // namespace
}  // namespace bumpfoil
