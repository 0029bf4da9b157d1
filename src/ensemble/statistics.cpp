#include "bumpfoil/ensemble/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bumpfoil {
namespace {

constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();

/// Two-sided 95 % bounds of a normal distribution, in standard deviations.
constexpr double normal_95 = 1.959963984540054;

/// Value below which a fraction `p` of the sorted values lies; NaN beyond the known values.
double percentile_of(const std::vector<double>& sorted, double p) {
  if (sorted.empty()) return not_defined;
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(below);
  const double value = part > 0.0 ? sorted[below] + part * (sorted[below + 1] - sorted[below]) : sorted[below];
  return std::isfinite(value) ? value : not_defined;
}

}  // namespace

Statistics statistics_of(std::vector<double> values, Undefined undefined) {
  const auto end_of_known =
      std::partition(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
  Statistics found;
  found.count = static_cast<std::size_t>(end_of_known - values.begin());
  found.undefined = values.size() - found.count;
  // Sorted first, so that sums do not depend on the order of input.
  std::sort(values.begin(), end_of_known);
  double sum = 0.0;
  for (auto value = values.begin(); value != end_of_known; ++value) sum += *value;
  const auto n = static_cast<double>(found.count);
  found.mean = found.count > 0 ? sum / n : not_defined;
  double squares = 0.0;
  for (auto value = values.begin(); value != end_of_known; ++value) {
    squares += (*value - found.mean) * (*value - found.mean);
  }
  found.deviation = found.count > 1 ? std::sqrt(squares / (n - 1.0)) : not_defined;
  found.standard_error = found.deviation / std::sqrt(n);
  found.mean_low = found.mean - normal_95 * found.standard_error;
  found.mean_high = found.mean + normal_95 * found.standard_error;
  if (undefined == Undefined::largest) {
    std::fill(end_of_known, values.end(), std::numeric_limits<double>::infinity());
  } else {
    values.erase(end_of_known, values.end());
  }
  for (std::size_t i = 0; i < percentiles.size(); ++i) {
    found.percentile[i] = percentile_of(values, 0.01 * percentiles[i]);
  }
  return found;
}

}  // namespace bumpfoil
