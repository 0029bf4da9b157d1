#include "structure/series.hpp"

#include <cmath>

namespace bumpfoil {
namespace {

/// Twelve terms leave a remainder below 1e-20 of the first for |x| <= 1.
constexpr int terms = 12;

}  // namespace

double x_minus_sin(double x) {
  if (std::abs(x) > 1.0) return x - std::sin(x);
  double term = x * x * x / 6.0;
  double sum = term;
  for (int k = 2; k <= terms; ++k) {
    term *= -x * x / ((2.0 * k) * (2.0 * k + 1.0));
    sum += term;
  }
  return sum;
}

double sin_minus_x_cos(double x) {
  if (std::abs(x) > 1.0) return std::sin(x) - x * std::cos(x);
  double term = x * x * x / 6.0;
  double sum = 2.0 * term;
  for (int k = 2; k <= terms; ++k) {
    term *= -x * x / ((2.0 * k) * (2.0 * k + 1.0));
    sum += 2.0 * k * term;
  }
  return sum;
}

}  // namespace bumpfoil
