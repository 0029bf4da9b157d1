#include "bumpfoil/bearing/impedance.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace bumpfoil {
namespace {

using Complex = std::complex<double>;

/// Two motions, three w: a pair of rows and one alone, as Schur's form has them.
FilmImpedance drawn_impedance() {
  FilmImpedance impedance{.shift = 3.0,
                          .squeeze_time = 0.5,
                          .moved = Eigen::Matrix2d{{3.0, 0.2}, {-1.0, 7.0}},
                          .start = Matrix(3, 2),
                          .schur = Matrix(3, 3),
                          .forces = Matrix(2, 3)};
  impedance.start << 2.0, 0.1, 0.3, -1.0, 0.7, 0.4;
  impedance.schur << -0.5, 0.3, 0.2, -0.4, -0.5, 0.6, 0.0, 0.0, -0.8;
  impedance.forces << 4.0, 0.5, -2.0, 1.0, 3.0, 0.1;
  return impedance;
}

TEST(FilmImpedance, SolvesForWhatIsStored) {
  FilmImpedance impedance = drawn_impedance();
  const auto check = [&](Complex e) {
    const Eigen::MatrixXcd system = Eigen::Matrix3cd::Identity() - e * impedance.schur.cast<Complex>();
    EXPECT_LT((system * impedance.stored(e) - impedance.start.cast<Complex>()).norm(), 1e-14) << e;
  };
  check({1.0, 2.0});
  check(0.0);
  // The pair below instead.
  impedance.schur << -0.8, 0.3, 0.2, 0.0, -0.5, 0.6, 0.0, -0.4, -0.5;
  check({-0.3, 1.0});
}

TEST(FilmImpedance, IsThatOfTheEquations) {
  const FilmImpedance impedance = drawn_impedance();
  const Complex e = 0.5 * Complex(0.0, 8.0) - 3.0;
  const Eigen::MatrixXcd w = impedance.stored(e);
  const Eigen::MatrixXcd expected = impedance.moved.cast<Complex>() + e * (impedance.forces.cast<Complex>() * w);
  EXPECT_LT((impedance.at({0.0, 8.0}) - expected).norm(), 1e-14);
}

TEST(LinearImpedance, IsThatOfSpringsAndDampers) {
  const JournalMatrix K = Eigen::Matrix2d{{5.0, 1.0}, {-1.0, 4.0}};
  const JournalMatrix C = Eigen::Matrix2d{{0.3, 0.0}, {0.1, 0.2}};
  const Complex s(-0.2, 8.0);
  EXPECT_LT((linear_impedance(K, C, 3.0).at(s) - (K.cast<Complex>() + s * C.cast<Complex>())).norm(), 1e-14);
}

}  // namespace
}  // namespace bumpfoil
