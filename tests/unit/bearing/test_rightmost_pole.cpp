#include "bearing/rightmost_pole.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

constexpr double shift = 2.0;

/// (A - shift)^-1 of a matrix A with these eigenvalues, conjugates included, in coordinates that hide them.
Matrix operator_of(const std::vector<Complex>& poles) {
  Eigen::Index n = 0;
  for (const Complex pole : poles) n += pole.imag() == 0.0 ? 1 : 2;
  Matrix A = Matrix::Zero(n, n);
  Eigen::Index i = 0;
  for (const Complex pole : poles) {
    A(i, i) = pole.real();
    if (pole.imag() != 0.0) {
      A(i + 1, i + 1) = pole.real();
      A(i, i + 1) = pole.imag();
      A(i + 1, i) = -pole.imag();
      ++i;
    }
    ++i;
  }
  std::srand(5);
  const Matrix turned = Matrix::Random(n, n) + 4.0 * Matrix::Identity(n, n);
  const Matrix identity = Matrix::Identity(n, n);
  return turned * solve(A - shift * identity, solve(turned, identity));
}

std::optional<FilmPole> found(const Matrix& C, double frequency) {
  return rightmost_pole([&](const Vector& w) -> Vector { return C * w; }, C.rows(), frequency);
}

/// As for a film: a few poles near the axis, and increasingly fast decay.
std::vector<Complex> with_decays(std::vector<Complex> poles) {
  for (int i = 1; i <= 80; ++i) poles.emplace_back(-3.0 - 1.2 * i, i % 3 == 0 ? 0.5 * i : 0.0);
  return poles;
}

TEST(RightmostPole, IsTheOneFarthestToTheRightAndNotTheNearest) {
  // Nearer to the shift: -0.2. Both of the pair are as good.
  const Matrix C = operator_of(with_decays({{-0.2, 0.0}, {-0.1, 2.9}, {-0.7, 1.0}}));
  const auto pole = found(C, 3.0);
  ASSERT_TRUE(pole.has_value());
  EXPECT_LT(std::abs(shift + pole->excess - Complex(-0.1, 2.9)), 1e-9);
  EXPECT_GE(pole->covered, 3.0);
  EXPECT_LT((pole->stored - pole->excess * (C * pole->stored)).norm(), 1e-9 * pole->stored.norm());
}

TEST(RightmostPole, MayGrowFasterThanTheShift) {
  const auto pole = found(operator_of(with_decays({{0.4, 0.9}, {2.7, 0.0}})), 3.0);
  ASSERT_TRUE(pole.has_value());
  EXPECT_NEAR((shift + pole->excess).real(), 2.7, 1e-9);
  EXPECT_NEAR(pole->excess.imag(), 0.0, 1e-12);
}

TEST(RightmostPole, OfASpaceThatEndsIsTheRightmostOfAll) {
  const auto pole = found(operator_of({{-4.0, 50.0}, {-5.0, 0.0}}), 3.0);
  ASSERT_TRUE(pole.has_value());
  EXPECT_LT(std::abs(shift + pole->excess - Complex(-4.0, 50.0)), 1e-8);
}

TEST(RightmostPole, IsNotGivenWhereTheCircleDoesNotReachAsFar) {
  // Poles at equal distances all around are as many as the space has directions: none comes out before all.
  std::vector<Complex> poles;
  for (int i = 1; i <= 150; ++i) poles.push_back(shift - std::polar(4.0, 0.01 * i));
  EXPECT_FALSE(found(operator_of(poles), 3.0).has_value());
}

}  // namespace
}  // namespace bumpfoil
