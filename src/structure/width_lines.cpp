#include "bumpfoil/structure/width_lines.hpp"

#include <cmath>
#include <numbers>

namespace bumpfoil {
namespace {

/// x P_n - P_{n-1}, which is (x^2 - 1) P_n' / n.
double scaled_slope(int n, double x) {
  return x * legendre(n, x) - legendre(n - 1, x);
}

/// Root i of P_n from the largest on, by Newton's method.
double gauss_point(int n, int i) {
  double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
  constexpr int enough = 6;  // the first guess is good to a hundredth, and the error is squared each time
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

WidthLines make_width_lines(int modes) {
  WidthLines lines{.orders = {}, .zeta = Vector(modes), .weight = Vector(modes), .to_modes = Matrix(modes, modes)};
  const int n = 2 * modes;  // points on the whole width, mirrored
  for (int s = 0; s < modes; ++s) {
    const double x = gauss_point(n, modes - 1 - s);
    const double slope = n * scaled_slope(n, x);
    lines.zeta[s] = x;
    lines.weight[s] = 2.0 * (1.0 - x * x) / (slope * slope);
    lines.orders.push_back(2 * s);
  }
  lines.weight /= lines.weight.sum();  // but for round-off 1 already, and exactly 1 for one line
  for (int k = 0; k < modes; ++k) {
    for (int s = 0; s < modes; ++s) {
      lines.to_modes(k, s) = (4 * k + 1) * lines.weight[s] * legendre(2 * k, lines.zeta[s]);
    }
  }
  return lines;
}

}  // namespace bumpfoil
