#include "bumpfoil/structure/width_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bumpfoil {
namespace {

TEST(WidthLines, OneLineIsTheWholeWidthToTheLastBit) {
  for (const WidthPart width : {WidthPart::half, WidthPart::whole}) {
    const WidthLines lines = make_width_lines(1, width);
    EXPECT_EQ(lines.weight, Vector::Ones(1));
    EXPECT_EQ(lines.to_modes, Matrix::Ones(1, 1));
    EXPECT_EQ(lines.shapes(0.3), Vector::Ones(1));
    EXPECT_EQ(lines.to_stretching_modes().rows(), 0);
  }
}

TEST(WidthLines, StandAtThePointsOfGaussOnHalfTheWidth) {
  const WidthLines lines = make_width_lines(3, WidthPart::half);
  EXPECT_EQ(lines.orders, (std::vector<int>{0, 2}));
  EXPECT_NEAR(lines.zeta[0], 0.339981043584856, 1e-14);
  EXPECT_NEAR(lines.zeta[1], 0.861136311594053, 1e-14);
  EXPECT_NEAR(lines.weight[0], 0.652145154862546, 1e-14);
  EXPECT_NEAR(lines.weight[1], 0.347854845137454, 1e-14);
}

TEST(WidthLines, StandAtThePointsOfGaussOnTheWholeWidth) {
  const WidthLines lines = make_width_lines(3, WidthPart::whole);
  EXPECT_EQ(lines.orders, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(lines.stretching_orders(), std::vector<int>{2});
  const double outer = std::sqrt(0.6);
  EXPECT_LT((lines.zeta - Eigen::Vector3d(-outer, 0.0, outer)).norm(), 1e-14);
  EXPECT_LT((lines.weight - Eigen::Vector3d(5.0, 8.0, 5.0) / 18.0).norm(), 1e-14);
  EXPECT_EQ(lines.to_stretching_modes(), lines.to_modes.row(2));
}

/// On half the width odd modes are undetermined.
TEST(WidthLines, OfHalfTheWidthHaveTheEvenModes) {
  for (const int modes : {3, 4}) {
    EXPECT_EQ(make_width_lines(modes, WidthPart::half).orders, (std::vector<int>{0, 2}));
  }
  EXPECT_EQ(make_width_lines(2, WidthPart::half).orders, std::vector<int>{0});
}

TEST(WidthLines, GiveDisplacementsByLinesOrByModesAlike) {
  for (const WidthPart width : {WidthPart::half, WidthPart::whole}) {
    const WidthLines lines = make_width_lines(5, width);
    const Eigen::Index n = lines.count();
    for (Eigen::Index s = 0; s < n; ++s) {
      EXPECT_LT((lines.shapes(lines.zeta[s]) - Vector::Unit(n, s)).norm(), 1e-13);
      // The values of a mode are those of its polynomial on the lines.
      for (Eigen::Index k = 0; k < n; ++k) {
        Vector values(n);
        for (Eigen::Index t = 0; t < n; ++t) {
          values[t] = legendre(lines.orders[static_cast<std::size_t>(k)], lines.zeta[t]);
        }
        EXPECT_LT((lines.to_modes * values - Vector::Unit(n, k)).norm(), 1e-13);
      }
    }
  }
}

/// This makes slices of the foil independent beams.
TEST(WidthLines, HaveOrthogonalShapes) {
  for (const WidthPart width : {WidthPart::half, WidthPart::whole}) {
    const WidthLines lines = make_width_lines(3, width);
    Matrix products = Matrix::Zero(lines.count(), lines.count());
    constexpr int intervals = 200;
    for (int i = 0; i <= intervals; ++i) {
      const double part = static_cast<double>(i) / intervals;
      const Vector N = lines.shapes(width == WidthPart::half ? part : 2.0 * part - 1.0);
      const double simpson = i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      products += simpson / (3.0 * intervals) * N * N.transpose();
    }
    EXPECT_LT((products - Matrix(lines.weight.asDiagonal())).norm(), 1e-7);
  }
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
