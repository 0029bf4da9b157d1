#include "bumpfoil/structure/width_lines.hpp"

#include <gtest/gtest.h>

namespace bumpfoil {
namespace {

TEST(WidthLines, OneLineIsTheWholeWidthToTheLastBit) {
  const WidthLines lines = make_width_lines(1);
  EXPECT_EQ(lines.weight, Vector::Ones(1));
  EXPECT_EQ(lines.to_modes, Matrix::Ones(1, 1));
  EXPECT_EQ(lines.shapes(0.3), Vector::Ones(1));
  EXPECT_EQ(lines.to_varying_modes().rows(), 0);
}

TEST(WidthLines, StandAtThePointsOfGaussOnHalfTheWidth) {
  const WidthLines lines = make_width_lines(2);
  EXPECT_NEAR(lines.zeta[0], 0.339981043584856, 1e-14);
  EXPECT_NEAR(lines.zeta[1], 0.861136311594053, 1e-14);
  EXPECT_NEAR(lines.weight[0], 0.652145154862546, 1e-14);
  EXPECT_NEAR(lines.weight[1], 0.347854845137454, 1e-14);
}

TEST(WidthLines, GiveDisplacementsByLinesOrByModesAlike) {
  for (const int modes : {2, 3}) {
    const WidthLines lines = make_width_lines(modes);
    for (Eigen::Index s = 0; s < lines.count(); ++s) {
      EXPECT_LT((lines.shapes(lines.zeta[s]) - Vector::Unit(modes, s)).norm(), 1e-13);
      // A mode is what its polynomial has on the lines.
      for (Eigen::Index k = 0; k < modes; ++k) {
        Vector values(modes);
        for (Eigen::Index t = 0; t < modes; ++t) values[t] = legendre(2 * static_cast<int>(k), lines.zeta[t]);
        EXPECT_LT((lines.to_modes * values - Vector::Unit(modes, k)).norm(), 1e-13);
      }
    }
  }
}

/// What makes slices of the foil beams that do not know of each other.
TEST(WidthLines, HaveOrthogonalShapes) {
  const WidthLines lines = make_width_lines(2);
  Matrix products = Matrix::Zero(2, 2);
  constexpr int intervals = 200;
  for (int i = 0; i <= intervals; ++i) {
    const Vector N = lines.shapes(static_cast<double>(i) / intervals);
    const double simpson = i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    products += simpson / (3.0 * intervals) * N * N.transpose();
  }
  EXPECT_LT((products - Matrix(lines.weight.asDiagonal())).norm(), 1e-9);
}

TEST(Legendre, PolynomialsAreTheKnownOnes) {
  const double x = 0.37;
  EXPECT_DOUBLE_EQ(legendre(0, x), 1.0);
  EXPECT_DOUBLE_EQ(legendre(1, x), x);
  EXPECT_DOUBLE_EQ(legendre(2, x), 1.5 * x * x - 0.5);
  EXPECT_NEAR(legendre(4, x), (35.0 * x * x * x * x - 30.0 * x * x + 3.0) / 8.0, 1e-15);
}

}  // namespace
}  // namespace bumpfoil
