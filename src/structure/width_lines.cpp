#include "bumpfoil/structure/width_lines.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace bumpfoil {
namespace {

/// x P_n - P_{n-1}, which is (x^2 - 1) P_n' / n.
double scaled_slope(int n, double x) {
  return x * legendre(n, x) - legendre(n - 1, x);
}

/// Root i of P_n in descending order, by Newton's method.
double gauss_point(int n, int i) {
  double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
  constexpr int enough = 6;  // the first guess is accurate to 0.01; convergence is quadratic
  for (int iteration = 0; iteration < enough; ++iteration)
    x -= (x * x - 1.0) * legendre(n, x) / (n * scaled_slope(n, x));
  return x;
}

}  // namespace

double legendre(int k, double x) {
  double before = 0.0;
  double value = 1.0;
  for (int n = 0; n < k; ++n) {
    const double next = ((2 * n + 1) * x * value - n * before) / (n + 1);
    before = value;
    value = next;
  }
  return value;
}

Vector WidthLines::shapes(double at) const {
  Vector values = Vector::Zero(count());
  for (std::size_t k = 0; k < orders.size(); ++k) {
    values += legendre(orders[k], at) * to_modes.row(static_cast<Eigen::Index>(k)).transpose();
  }
  return values;
}

std::vector<int> WidthLines::stretching_orders() const {
  std::vector<int> higher;
  std::copy_if(orders.begin(), orders.end(), std::back_inserter(higher), [](int k) { return k >= 2; });
  return higher;
}

Matrix WidthLines::to_stretching_modes() const {
  return to_modes.bottomRows(std::ssize(stretching_orders()));
}

WidthLines make_width_lines(int modes, WidthPart width) {
  const bool half = width == WidthPart::half;
  const int count = half ? (modes + 1) / 2 : modes;
  const int points = half ? 2 * count : count;  // on the whole width, by symmetry
  WidthLines lines{.orders = {}, .zeta = Vector(count), .weight = Vector(count), .to_modes = Matrix(count, count)};
  for (int s = 0; s < count; ++s) {
    const double x = gauss_point(points, count - 1 - s);
    const double slope = points * scaled_slope(points, x);
    lines.zeta[s] = x;
    lines.weight[s] = 2.0 * (1.0 - x * x) / (slope * slope);
    lines.orders.push_back(half ? 2 * s : s);
  }
  lines.weight /= lines.weight.sum();  // 1 up to round-off already; exactly 1 for one line
  for (int i = 0; i < count; ++i) {
    const int k = lines.orders[static_cast<std::size_t>(i)];
    for (int s = 0; s < count; ++s) {
      lines.to_modes(i, s) = (2 * k + 1) * lines.weight[s] * legendre(k, lines.zeta[s]);
    }
  }
  return lines;
}

}  // namespace bumpfoil
