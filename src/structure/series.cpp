#include "structure/series.hpp"

#include <cmath>

namespace bumpfoil {
namespace {

/// Sum over k >= first of (-1)^(k - first) weight(k) x^(2 (k - first)) / (2 k + 1)!. Twenty terms leave a remainder
/// below 1e-20 of the sum for |x| <= 4.
template <typename Weight>
double sine_like_series(double x, int first, Weight weight) {
  constexpr int terms = 20;
  double term = 1.0;
  for (int i = 2; i <= 2 * first + 1; ++i) term /= i;
  double sum = 0.0;
  for (int k = first; k < first + terms; ++k) {
    sum += weight(static_cast<double>(k)) * term;
    term *= -x * x / ((2.0 * k + 2.0) * (2.0 * k + 3.0));
  }
  return sum;
}

}  // namespace

double sine_remainder(double x) {
  if (std::abs(x) > 1.0) return (x - std::sin(x)) / (x * x * x);
  return sine_like_series(x, 1, [](double) { return 1.0; });
}

double sine_moment(double x) {
  if (std::abs(x) > 1.0) return (std::sin(x) - x * std::cos(x)) / (x * x * x);
  return sine_like_series(x, 1, [](double k) { return 2.0 * k; });
}

double arc_bow(double x) {
  if (std::abs(x) > 4.0) return (0.5 * (x + std::sin(x)) - 2.0 * (1.0 - std::cos(x)) / x) / std::pow(x, 5);
  return sine_like_series(x, 2, [](double k) { return 0.5 * (k - 1.0) / (k + 1.0); });
}

}  // namespace bumpfoil
