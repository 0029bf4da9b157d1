#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstring>

#include "bumpfoil/core/dense_kernels.hpp"

namespace bumpfoil {

/// The smallest interval that contains some numbers and zero.
struct Extremes {
  double least{};
  double most{};

  /// The largest absolute value.
  [[nodiscard]] double size() const { return std::max(most, -least); }
};

/// Extremes of `numbers`, of which what is not a number is left out. For inner loops: Eigen finds one extreme at a
/// time.
inline Extremes extremes_of(const Eigen::VectorXd& numbers) {
  return with_widest_vectors([&numbers](auto lanes) BUMPFOIL_ALWAYS_INLINE {
    constexpr int n = decltype(lanes)::value;
    using Row = typename VectorOf<n>::Type;
    const double* const number = numbers.data();
    const Eigen::Index count = numbers.size();
    Row most{};
    Row least{};
    Extremes extremes;
    Eigen::Index i = 0;
    for (; i + n <= count; i += n) {
      Row row;
      std::memcpy(&row, number + i, sizeof row);
      most = row > most ? row : most;
      least = row < least ? row : least;
    }
    for (; i < count; ++i) extremes = {std::min(extremes.least, number[i]), std::max(extremes.most, number[i])};
    for (int k = 0; k < n; ++k) extremes = {std::min(extremes.least, least[k]), std::max(extremes.most, most[k])};
    return extremes;
  });
}

}  // namespace bumpfoil
