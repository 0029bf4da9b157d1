#include "bumpfoil/structure/membrane.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/structure/width_lines.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// The foil of [Arghir2019, Table 1].
constexpr double half_width = 19.05e-3;
constexpr double radius = 19.05e-3;
constexpr double stretching = 214e9 * 0.102e-3;
constexpr double poisson_ratio = 0.29;

Membrane example() {
  return make_membrane({2}, half_width, radius, stretching, poisson_ratio);
}

/// Dense equations of all columns except the last: F of all columns, then g.
Matrix dense(const std::vector<MembraneRows>& rows) {
  const auto n = std::ssize(rows);
  const Eigen::Index m = rows.front().own.rows() / 2;
  Matrix A = Matrix::Zero(2 * m * n, 2 * m * n);
  const auto places = [&](Eigen::Index column) {
    Eigen::VectorXi at(2 * m);
    for (int i = 0; i < 2 * m; ++i) at[i] = static_cast<int>(i < m ? m * column + i : m * n + m * column + i - m);
    return at;
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    const MembraneRows& row = rows[static_cast<std::size_t>(i)];
    if (i > 0) A(places(i), places(i - 1)) += row.before;
    A(places(i), places(i)) += row.own;
    if (i + 1 < n) A(places(i), places(i + 1)) += row.after;
  }
  return A;
}

TEST(StressFunction, IntegralsAreThoseOfPolynomials) {
  const double a = 1.7;
  const StressFunctionIntegrals even = stress_function_integrals({2, 4}, a);
  const StressFunctionIntegrals odd = stress_function_integrals({3}, a);
  const double a3 = a * a * a;
  const double a5 = a3 * a * a;
  EXPECT_NEAR(even.A(0, 0), 4.0 * a5 / 315.0, 1e-12);
  EXPECT_NEAR(even.A(0, 1), -0.0007696007696007692 * a5, 1e-12);
  EXPECT_NEAR(even.A(1, 0), even.A(0, 1), 1e-15);
  EXPECT_NEAR(even.A(1, 1), 0.00026640026640026624 * a5, 1e-12);
  EXPECT_NEAR(odd.A(0, 0), 0.0011544011544011533 * a5, 1e-12);
  EXPECT_NEAR(even.B(0, 0), 4.0 * a3 / 105.0, 1e-12);
  EXPECT_NEAR(even.B(0, 1), -2.0 * a3 / 315.0, 1e-12);
  EXPECT_NEAR(even.B(1, 1), 0.005772005772005769 * a3, 1e-12);
  EXPECT_NEAR(odd.B(0, 0), 4.0 * a3 / 315.0, 1e-12);
  EXPECT_NEAR(even.G[0], 0.4 * a, 1e-12);
  EXPECT_NEAR(even.G[1], 2.0 / 9.0 * a, 1e-12);
  EXPECT_NEAR(odd.G[0], 2.0 / 7.0 * a, 1e-12);
}

/// Integrals of chi_2 = (1 - zeta^2)^2 / 8, computed separately.
TEST(StressFunction, VanishesAtTheSideEdges) {
  const auto chi = [](double zeta) { return (1.0 - zeta * zeta) * (1.0 - zeta * zeta) / 8.0; };
  constexpr double h = 1e-3;
  for (const double zeta : {0.0, 0.4, 0.9}) {
    EXPECT_NEAR((chi(zeta + h) - 2.0 * chi(zeta) + chi(zeta - h)) / (h * h), legendre(2, zeta), 1e-6);
  }
  double sum = 0.0;
  constexpr int intervals = 400;
  for (int i = 0; i <= intervals; ++i) {
    const double simpson = i == 0 || i == intervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += 2.0 * simpson / (3.0 * intervals) * std::pow(chi(static_cast<double>(i) / intervals), 2);
  }
  EXPECT_NEAR(stress_function_integrals({2}, 1.0).A(0, 0), sum, 1e-9);
}

/// The foil is displaced by 1 um P_2 everywhere except at the weld: hoop tension of columns, six per pitch, from an
/// independent program.
TEST(Membrane, IsStretchedByAParabolaOverTheWidth) {
  constexpr int columns = 156;
  const Membrane membrane = example();
  const std::vector<MembraneRows> rows = membrane_rows(membrane, Vector::Constant(columns, 4.572e-3 / 6.0));
  Vector right = Vector::Zero(2 * columns);
  for (int i = 1; i < columns; ++i) right[i] = rows[static_cast<std::size_t>(i)].length * 1e-6;
  const Vector solution = solve(dense(rows), right);
  const double to_tension = radius / (0.4 * half_width);  // f = F R / G
  const Vector f = to_tension * solution.head(columns);
  const std::pair<int, double> reference[]{{0, 1041.847},   {3, 1078.872},   {6, 1105.604},   {12, 1137.162},
                                           {30, 1154.295},  {78, 1148.817},  {120, 1045.774}, {144, 385.1063},
                                           {150, 134.0124}, {153, 39.87523}, {155, 5.127075}};
  for (const auto& [column, tension] : reference) {
    EXPECT_NEAR(f[column], tension, 1e-6 * 1145.827) << column;  // N/m
  }
  // Far from both ends E t w / R, except for a wave that decays over two pitches.
  EXPECT_NEAR(f[60], stretching * 1e-6 / radius, 2e-3 * 1145.827);
}

/// The rows are derivatives of one energy: with g eliminated they are symmetric and positive definite.
TEST(Membrane, RowsAreThoseOfAnEnergy) {
  const Membrane membrane = make_membrane({2, 4}, half_width, radius, stretching, poisson_ratio);
  const Vector intervals = 1e-3 * Vector::LinSpaced(12, 0.5, 1.2);  // unequal intervals
  const Matrix A = dense(membrane_rows(membrane, intervals));
  const Eigen::Index n = A.rows() / 2;
  const Matrix eliminated = A.topLeftCorner(n, n) -
                            A.topRightCorner(n, n) * solve(A.bottomRightCorner(n, n), Matrix(A.bottomLeftCorner(n, n)));
  EXPECT_LT((eliminated - eliminated.transpose()).norm(), 1e-12 * eliminated.norm());
  EXPECT_GT(symmetric_eigenvalues(0.5 * (eliminated + eliminated.transpose())).minCoeff(), 0.0);
}

/// A uniform load on a mode far from the ends: no curvature.
TEST(Membrane, IsAFoundationWhereNothingVaries) {
  const Membrane membrane = example();
  const std::vector<MembraneRows> rows = membrane_rows(membrane, Vector::Constant(20, 1e-3));
  const MembraneRows& row = rows[10];
  const Vector uniform = Vector::Unit(2, 0);
  const Vector stretch = (row.before + row.own + row.after) * uniform;
  EXPECT_NEAR(stretch[0] / row.length, membrane.by_load[0], 1e-9 * membrane.by_load[0]);
  EXPECT_NEAR(stretch[1], 0.0, 1e-9);
  EXPECT_NEAR(membrane.by_load[0], radius * radius / (stretching * 0.4 * half_width), 1e-12 * membrane.by_load[0]);
}

}  // namespace
}  // namespace bumpfoil
