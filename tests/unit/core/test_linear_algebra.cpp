#include "core/linear_algebra.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <initializer_list>
#include <limits>

namespace bumpfoil {
namespace {

constexpr double round_off = 1e-14;  // of numbers about one

Eigen::VectorXd numbers(std::initializer_list<double> values) {
  return Eigen::VectorXd::Map(values.begin(), static_cast<Eigen::Index>(values.size()));
}

Eigen::MatrixXd square(std::initializer_list<double> rows) {
  const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(rows.size()))));
  return Eigen::MatrixXd::Map(rows.begin(), n, n).transpose();
}

TEST(LinearAlgebra, Multiplies) {
  Eigen::MatrixXd A(2, 3);
  A << 1, 2, 3, 4, 5, 6;
  const Eigen::MatrixXd B = square({1, 0, 2, 0, 1, 0, 1, 1, 1});
  Eigen::MatrixXd AB(2, 3);
  AB << 4, 5, 5, 10, 11, 14;
  EXPECT_EQ(product(A, B), AB);
  EXPECT_EQ(transposed_product(A.transpose(), B), AB);
  EXPECT_EQ(congruent(B, A.transpose()), square({29, 71, 74, 179}));
}

TEST(LinearAlgebra, SolvesWhereRowsMustBeExchanged) {
  const Eigen::MatrixXd A = square({0, 2, 1, 3});
  Eigen::MatrixXd B(2, 2);
  B << 2, 4, 4, 7;
  Eigen::MatrixXd X(2, 2);
  X << 1, 1, 1, 2;
  EXPECT_LT((solve(A, B) - X).norm(), round_off);
  EXPECT_LT((solve(A, numbers({2, 4})) - numbers({1, 1})).norm(), round_off);
  const std::complex<double> i(0.0, 1.0);
  const Eigen::VectorXcd b = i * numbers({2, 4}).cast<std::complex<double>>();
  EXPECT_LT((solve(Eigen::MatrixXcd(i * A), b) - numbers({1, 1})).norm(), round_off);
}

TEST(LinearAlgebra, SolvesSymmetricEquationsFromTheLowerTriangle) {
  const Eigen::MatrixXd B = numbers({3, 5});
  EXPECT_LT((solve_symmetric(square({2, 99, 1, 3}), B) - numbers({0.8, 1.4})).norm(), round_off);
}

TEST(LinearAlgebra, SolvesPositiveEquationsFromTheLowerTriangle) {
  const Eigen::MatrixXd B = numbers({3, 5});
  EXPECT_LT((solve_positive(square({2, 99, 1, 3}), B) - numbers({0.8, 1.4})).norm(), round_off);
}

TEST(LinearAlgebra, InvertsWhatIsDefiniteEnough) {
  const Eigen::MatrixXd A = square({2, 99, 1, 3});  // L D L^T from the largest entry on: D = 3, 5 / 3
  const auto inverse = definite_inverse(A, 1.66);
  ASSERT_TRUE(inverse.has_value());
  EXPECT_LT((*inverse - square({0.6, -0.2, -0.2, 0.4})).norm(), round_off);
  EXPECT_FALSE(definite_inverse(A, 1.67).has_value());
  EXPECT_FALSE(definite_inverse(square({1, 2, 2, 1}), 0.0).has_value());
}

TEST(LinearAlgebra, FindsAllThatIsMappedToZero) {
  Eigen::MatrixXd A(2, 5);
  A << 0, 1, -2, 0, 4, 0, 3, 0.5, 0, -1;
  const Eigen::MatrixXd null = null_space(A);
  ASSERT_EQ(null.cols(), 3);
  EXPECT_LT((A * null).norm(), round_off);
  EXPECT_LT((null.transpose() * null - Eigen::Matrix3d::Identity()).norm(), round_off);
}

/// Columns (3, 0, 4), (4, 0, -3) / 5 and (0, 2, 0): orthogonal, of lengths 5, 1 and 2.
TEST(LinearAlgebra, GivesSingularValuesInOrderWithTheirVectors) {
  Eigen::MatrixXd A(3, 3);
  A << 3, 0.8, 0, 0, 0, 2, 4, -0.6, 0;
  const auto [values, right] = singular_vectors(A);
  EXPECT_LT((values - numbers({5, 2, 1})).norm(), round_off);
  EXPECT_LT((right.cwiseAbs() - square({1, 0, 0, 0, 0, 1, 0, 1, 0})).norm(), round_off);
}

TEST(LinearAlgebra, GivesAsManySingularValuesAsColumns) {
  Eigen::MatrixXd A(1, 2);
  A << 3, 4;
  const auto [values, right] = singular_vectors(A);
  EXPECT_LT((values - numbers({5, 0})).norm(), round_off);
  EXPECT_LT((right.col(0).cwiseAbs() - numbers({0.6, 0.8})).norm(), round_off);
  EXPECT_NEAR((A * right.col(1)).norm(), 0.0, round_off);
}

TEST(LinearAlgebra, GivesEigenvaluesOfSymmetricMatricesInOrder) {
  EXPECT_LT((symmetric_eigenvalues(square({2, 1, 1, 2})) - numbers({1, 3})).norm(), round_off);
}

/// Two masses 1 and 4 on springs 2 and 12 that do not couple them.
TEST(LinearAlgebra, ScalesShapesToUnitMass) {
  const SymmetricModes modes = symmetric_modes(square({2, 0, 0, 12}), square({1, 0, 0, 4}));
  EXPECT_LT((modes.squares - numbers({2, 3})).norm(), round_off);
  EXPECT_NEAR(std::abs(modes.shapes(0, 0)), 1.0, round_off);
  EXPECT_NEAR(std::abs(modes.shapes(1, 1)), 0.5, round_off);
}

/// A turn by a quarter and a stretch: i, -i and 3.
TEST(LinearAlgebra, FindsComplexEigenpairs) {
  const Eigen::MatrixXd A = square({0, -1, 0, 1, 0, 0, 0, 0, 3});
  const auto pairs = eigenpairs(A);
  ASSERT_TRUE(pairs.has_value());
  EXPECT_EQ(pairs->values, eigenvalues(A));
  const std::complex<double> product = pairs->values.prod();
  EXPECT_NEAR(std::abs(product - 3.0), 0.0, round_off);
  EXPECT_NEAR(pairs->values.imag().maxCoeff(), 1.0, round_off);
  const Eigen::MatrixXcd residual = A * pairs->vectors - pairs->vectors * pairs->values.asDiagonal();
  EXPECT_LT(residual.norm(), round_off);
  EXPECT_LT((pairs->vectors.colwise().norm().array() - 1.0).matrix().norm(), round_off);
}

/// The QR algorithm ends without an answer.
TEST(LinearAlgebra, GivesNoEigenvaluesOfWhatIsNoNumber) {
  const Eigen::MatrixXd A = Eigen::MatrixXd::Constant(3, 3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(eigenvalues(A).has_value());
  EXPECT_FALSE(eigenpairs(A).has_value());
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
