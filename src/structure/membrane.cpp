#include "bumpfoil/structure/membrane.hpp"

#include <map>

#include "bumpfoil/core/assert.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// A sum of Legendre polynomials: coefficients by order.
using LegendreSum = std::map<int, double>;

/// chi_k' for a = 1: the integral of P_k from -1 on.
LegendreSum slope_of_chi(int k) {
  const double scale = 1.0 / (2 * k + 1);
  return {{k - 1, -scale}, {k + 1, scale}};
}

/// chi_k for a = 1: the integral of chi_k'.
LegendreSum chi(int k) {
  LegendreSum sum;
  for (const auto& [order, factor] : slope_of_chi(k)) {
    for (const auto& [higher, part] : slope_of_chi(order)) sum[higher] += factor * part;
  }
  return sum;
}

/// Integral of the product over [-1, 1].
double integral(const LegendreSum& a, const LegendreSum& b) {
  double sum = 0.0;
  for (const auto& [order, factor] : a) {
    const auto same = b.find(order);
    if (same != b.end()) sum += factor * same->second * 2.0 / (2 * order + 1);
  }
  return sum;
}

}  // namespace

StressFunctionIntegrals stress_function_integrals(const std::vector<int>& orders, double half_width) {
  const auto n = std::ssize(orders);
  StressFunctionIntegrals integrals{Matrix(n, n), Matrix(n, n), Vector(n)};
  const double a = half_width;
  for (Eigen::Index i = 0; i < n; ++i) {
    const int k = orders[static_cast<std::size_t>(i)];
    BUMPFOIL_ASSERT(k >= 2);
    integrals.G[i] = 2.0 * a / (2 * k + 1);
    for (Eigen::Index j = 0; j < n; ++j) {
      const int l = orders[static_cast<std::size_t>(j)];
      integrals.A(i, j) = a * a * a * a * a * integral(chi(k), chi(l));
      integrals.B(i, j) = a * a * a * integral(slope_of_chi(k), slope_of_chi(l));
    }
  }
  return integrals;
}

Membrane make_membrane(const std::vector<int>& orders, double half_width, double radius, double stretching,
                       double poisson_ratio) {
  const StressFunctionIntegrals integrals = stress_function_integrals(orders, half_width);
  const Vector per_load = integrals.G.cwiseInverse();
  const double scale = radius * radius / stretching;
  return {.by_bow = scale * per_load.asDiagonal() * integrals.A * per_load.asDiagonal(),
          .by_slope = scale * per_load.asDiagonal() * integrals.B * per_load.asDiagonal(),
          .by_load = scale * per_load,
          .poisson_ratio = poisson_ratio};
}

std::vector<MembraneRows> membrane_rows(const Membrane& membrane, const Vector& intervals) {
  const Eigen::Index m = membrane.modes();
  const Eigen::Index last = intervals.size() - 1;
  const Matrix& A = membrane.by_bow;
  const Matrix nu_B = membrane.poisson_ratio * membrane.by_slope;
  const Matrix shear = 2.0 * (1.0 + membrane.poisson_ratio) * membrane.by_slope;
  std::vector<MembraneRows> rows;
  rows.reserve(static_cast<std::size_t>(intervals.size()));
  for (Eigen::Index i = 0; i <= last; ++i) {
    const bool weld = i == 0;
    const double to_after = 1.0 / intervals[i];
    const double to_before = weld ? 0.0 : 1.0 / intervals[i - 1];
    MembraneRows row;
    row.length = 0.5 * (intervals[i] + (weld ? 0.0 : intervals[i - 1]));
    row.before = row.own = row.after = Matrix::Zero(2 * m, 2 * m);
    const auto F = Eigen::seqN(0, m);
    const auto g = Eigen::seqN(m, m);
    // Adds the transverse curvature source, m = A g + nu B F, of this column and its neighbours. None at the weld,
    // which suppresses it.
    const auto add_bow = [&](Matrix& block, double factor) {
      block(F, g) += factor * A;
      block(F, F) += factor * nu_B;
    };
    if (i > 1) add_bow(row.before, to_before);
    if (!weld) add_bow(row.own, -(to_before + to_after));
    if (i < last) add_bow(row.after, to_after);
    // At the end F = 0, and its g is 2 F / interval^2 of the previous column.
    if (i == last) row.own(F, F) += 2.0 * to_after * to_after * to_after * A;
    row.own(F, F) += row.length * Matrix(membrane.by_load.asDiagonal());
    row.own(F, g) += row.length * nu_B;
    row.own(F, F) += (to_before + to_after) * shear;
    if (!weld) row.before(F, F) -= to_before * shear;
    if (i < last) row.after(F, F) -= to_after * shear;
    row.own(g, g).setIdentity();
    if (weld) {
      row.own(g, F) = solve(A, nu_B);
    } else {
      row.own(g, g) *= row.length;
      row.before(g, F).diagonal().setConstant(-to_before);
      row.own(g, F).diagonal().setConstant(to_before + to_after);
      if (i < last) row.after(g, F).diagonal().setConstant(-to_after);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace bumpfoil
