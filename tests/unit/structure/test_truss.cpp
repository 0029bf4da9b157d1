#include "bumpfoil/structure/truss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

constexpr TrussConstants constants{
    .k1 = 150e6, .k2 = 5.43e6, .k3 = 1.36e6, .k4 = 11.25e6, .theta_d = 15.83 * std::numbers::pi / 180.0};
const BumpDofs dofs{.size = 4, .crest_u = 0, .crest_v = 1, .foot_u = {2}, .foot_v = {3}};

std::vector<TrussConstants> uniform(int bumps) {
  return std::vector<TrussConstants>(static_cast<std::size_t>(bumps), constants);
}

BlockTridiagonal assemble(int bumps) {
  BlockTridiagonal K(bumps, dofs.size);
  assemble_springs(make_truss_springs(uniform(bumps), dofs), K);
  return K;
}

TEST(Truss, EqualsThePublishedMatrixForTwoBumps) {
  // [Arghir2019, Eq. 9], upper triangle row by row; order u, v of crest 1, foot 1, crest 2, foot 2.
  const auto& [k1, k2, k3, k4, theta_d] = constants;
  const double c = std::cos(theta_d);
  const double s = std::sin(theta_d);
  Matrix published = Matrix::Zero(8, 8);
  published.row(0) << 2 * k1 * c * c + k3 + k4, 0, -k1 * c * c, -k1 * c * s, -k3, 0, 0, 0;
  published.row(1).tail(7) << 2 * k1 * s * s, -k1 * s * c, -k1 * s * s, 0, 0, 0, 0;
  published.row(2).tail(6) << 2 * k2 + 2 * k1 * c * c, 0, -k1 * c * c, k1 * c * s, -k2, 0;
  published.row(3).tail(5) << 2 * k1 * s * s, k1 * s * c, -k1 * s * s, 0, 0;
  published.row(4).tail(4) << k3 + 2 * k1 * c * c, 0, -k1 * c * c, -k1 * c * s;
  published.row(5).tail(3) << 2 * k1 * s * s, -k1 * s * c, -k1 * s * s;
  published.row(6).tail(2) << k2 + k1 * c * c, k1 * c * s;
  published(7, 7) = k1 * s * s;
  published.triangularView<Eigen::StrictlyLower>() = published.transpose();
  EXPECT_LT((assemble(2).dense() - published).norm(), 1e-15 * published.norm());
}

TEST(Truss, WithoutAWeldIsItsOwnMirrorImage) {
  // Blocks: the foot before bump 1, then three bumps. Mirrored, foot k becomes foot 3 - k, and u changes sign.
  BlockTridiagonal K(4, dofs.size);
  assemble_springs(make_truss_springs(uniform(3), dofs, false), K);
  const Matrix whole = K.dense();
  std::vector<Eigen::Index> order, mirrored;
  Vector sign(14);
  for (Eigen::Index foot = 0; foot < 4; ++foot) {
    for (Eigen::Index k = 0; k < 2; ++k) {
      sign[std::ssize(order)] = k == 0 ? -1.0 : 1.0;
      order.push_back(4 * foot + 2 + k);
      mirrored.push_back(4 * (3 - foot) + 2 + k);
    }
  }
  for (Eigen::Index bump = 1; bump < 4; ++bump) {
    for (Eigen::Index k = 0; k < 2; ++k) {
      sign[std::ssize(order)] = k == 0 ? -1.0 : 1.0;
      order.push_back(4 * bump + k);
      mirrored.push_back(4 * (4 - bump) + k);
    }
  }
  const Matrix image = sign.asDiagonal() * Matrix(whole(mirrored, mirrored)) * sign.asDiagonal();
  EXPECT_LT((image - whole(order, order)).norm(), 1e-15 * whole.norm());
  // Free to move along the foil; the unused crest of the first block has no coupling.
  Vector shift = Vector::Zero(16);
  for (Eigen::Index b = 0; b < 4; ++b) shift[4 * b] = shift[4 * b + 2] = 1.0;
  EXPECT_LT((whole * shift).norm(), 1e-15 * whole.norm());
  EXPECT_EQ(whole.topRows(2).norm(), 0.0);
}

TEST(Truss, EachBumpHasItsOwnSprings) {
  const std::vector<TrussConstants> graded{{.k1 = 100.0, .k2 = 10.0, .k3 = 7e3, .k4 = 3.0, .theta_d = 0.3},
                                           {.k1 = 200.0, .k2 = 20.0, .k3 = 5.0, .k4 = 7e3, .theta_d = 0.5},
                                           {.k1 = 300.0, .k2 = 30.0, .k3 = 6.0, .k4 = 7e3, .theta_d = 0.7}};
  BlockTridiagonal K(3, dofs.size);
  assemble_springs(make_truss_springs(graded, dofs), K);
  const Matrix dense = K.dense();
  for (Eigen::Index n = 0; n < 3; ++n) {
    const auto& [k1, k2, k3, k4, theta_d] = graded[static_cast<std::size_t>(n)];
    const double c = std::cos(theta_d);
    const double s = std::sin(theta_d);
    // Crests have their own rods, feet those of their bump and the next; crest to crest has the spring before the bump,
    // at bump 1 the spring to the weld.
    const double after = n < 2 ? graded[static_cast<std::size_t>(n + 1)].k3 : 0.0;
    EXPECT_DOUBLE_EQ(dense(4 * n, 4 * n), 2.0 * k1 * c * c + (n == 0 ? k4 : k3) + after);
    EXPECT_DOUBLE_EQ(dense(4 * n + 1, 4 * n + 1), 2.0 * k1 * s * s);
    double foot = k1 * c * c + k2;
    if (n < 2) {
      const TrussConstants& next = graded[static_cast<std::size_t>(n + 1)];
      foot += next.k1 * std::cos(next.theta_d) * std::cos(next.theta_d) + next.k2;
      EXPECT_DOUBLE_EQ(dense(4 * n + 2, 4 * n + 6), -next.k2);
      EXPECT_DOUBLE_EQ(dense(4 * n, 4 * n + 4), -next.k3);
    }
    EXPECT_DOUBLE_EQ(dense(4 * n + 2, 4 * n + 2), foot);
  }
}

TEST(Truss, IsTheHessianOfItsEnergy) {
  constexpr int bumps = 4;
  const std::vector<Spring> springs = make_truss_springs(uniform(bumps), dofs);
  const Matrix K = assemble(bumps).dense();
  const Eigen::Index n = K.rows();
  const auto energy = [&](const Vector& x) { return spring_energy(springs, dofs.size, x); };
  const Vector origin = Vector::LinSpaced(n, -1.0, 2.0).array().sin();
  // The energy is quadratic: central differences have no truncation error, and round-off falls with larger steps.
  constexpr double step = 1.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const Vector a = step * Vector::Unit(n, i);
      const Vector b = step * Vector::Unit(n, j);
      const double second =
          (energy(origin + a + b) - energy(origin + a - b) - energy(origin - a + b) + energy(origin - a - b)) /
          (4.0 * step * step);
      EXPECT_NEAR(second, K(i, j), 1e-13 * K.norm());
    }
  }
}

TEST(Truss, IsPositiveDefiniteForAnyNumberOfBumps) {
  for (const int bumps : {1, 2, 5, 26}) {
    const Vector modes = symmetric_eigenvalues(assemble(bumps).dense());
    EXPECT_GT(modes.minCoeff(), 0.0) << bumps;
    // cond(K) stays below 1e10: the open foil is soft, but far from singular.
    EXPECT_GT(modes.minCoeff(), 1e-10 * modes.maxCoeff()) << bumps;
  }
}

TEST(Truss, LongerTrussRepeatsItsBlocks) {
  const BlockTridiagonal K = assemble(7);
  EXPECT_EQ(K.diagonal[1], K.diagonal[5]);
  EXPECT_EQ(K.upper[0], K.upper[5]);
  EXPECT_NE(K.diagonal[0], K.diagonal[1]);  // k4 in place of k3
  EXPECT_NE(K.diagonal[5], K.diagonal[6]);  // nothing after the last foot
}

}  // namespace
}  // namespace bumpfoil
