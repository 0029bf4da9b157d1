#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {

/// Percentiles that statistics have, %.
inline constexpr std::array<int, 7> percentiles{1, 5, 25, 50, 75, 95, 99};

/// Statistics of a quantity that varies. Numbers that are undefined, for lack of values, are NaN.
struct Statistics {
  std::size_t count{};      ///< values that are defined
  std::size_t undefined{};  ///< and those that are not
  double mean{};
  double deviation{};       ///< standard deviation, with count - 1
  double standard_error{};  ///< of the mean: deviation / sqrt(count)
  double mean_low{};        ///< 95 % interval of the mean, 1.96 standard errors either way
  double mean_high{};
  std::array<double, percentiles.size()> percentile{};  ///< linear between the values in their order
};

/// Statistics of values, of which those that are not numbers are undefined. Means leave these out.
Statistics statistics_of(std::vector<double> values, Undefined undefined = Undefined::unknown);

}  // namespace bumpfoil
