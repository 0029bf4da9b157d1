#include "bearing/schur_form.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

Matrix drawn_matrix(Eigen::Index size) {
  std::srand(9);
  return Matrix::Random(size, size);
}

TEST(SchurForm, IsTheMatrixInAnotherBasis) {
  const Matrix A = drawn_matrix(11);
  const auto form = schur_form(A);
  ASSERT_TRUE(form.has_value());
  EXPECT_LT((form->U * form->T * form->U.transpose() - A).norm(), 1e-13 * A.norm());
  EXPECT_LT((form->U * form->U.transpose() - Matrix::Identity(11, 11)).norm(), 1e-13);
}

TEST(SchurForm, SolvesShiftedEquations) {
  const Matrix T = schur_form(drawn_matrix(11))->T;
  const Eigen::MatrixXcd right = Eigen::MatrixXcd::Random(11, 3);
  for (const Complex e : {Complex(0.4, -1.3), Complex(0.0, 0.0), Complex(-2.0, 0.0)}) {
    const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(11, 11) - e * T;
    EXPECT_LT((system * solve_shifted(T, e, right) - right).norm(), 1e-12 * right.norm()) << e;
  }
}

TEST(SchurForm, HasTheEigenvaluesAndEigenvectors) {
  const Matrix T = schur_form(drawn_matrix(11))->T;
  const std::vector<SchurEigenvalue> found = schur_eigenvalues(T);
  ASSERT_EQ(found.size(), 11U);
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const SchurEigenvalue& of) { return of.size == 1; }));
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const SchurEigenvalue& of) { return of.size == 2; }));
  Complex sum = 0.0;
  for (const SchurEigenvalue& of_one : found) {
    sum += of_one.value;
    const Eigen::VectorXcd v = eigenvector_of(T, of_one);
    EXPECT_NEAR(v.norm(), 1.0, 1e-14);
    EXPECT_LT((T * v - of_one.value * v).norm(), 1e-12 * T.norm()) << of_one.value;
  }
  EXPECT_LT(std::abs(sum - T.trace()), 1e-12 * T.norm());  // none twice
}

}  // namespace
}  // namespace bumpfoil
