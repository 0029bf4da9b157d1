#pragma once

#include <numbers>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Backward difference for a rate in a step in time: at the end of the step h_n, from the values y_n at its start and
/// y_{n-1} at the start of the previous step,
///
///     dy/dt = (y_{n+1} - y_ref) / span,      y_ref = now y_n + before y_{n-1}
///
/// for the content P H of a film, and in the same way for anything else that has a rate. A plain value.
struct BackwardDifference {
  double span{};    ///< s
  double now{1.0};  ///< weights, which add up to 1
  double before{};

  /// y_ref. @param y_before  is not read where its weight is zero
  [[nodiscard]] Matrix reference(const Matrix& y_now, const Matrix& y_before) const {
    if (before == 0.0) return y_now;
    return now * y_now + before * y_before;
  }
};

/// First order: span = h_n, y_ref = y_n. It damps growing motions, so its result says nothing about stability.
inline BackwardDifference implicit_euler(double dt) {
  return {.span = dt};
}

/// Second order for steps of any length: exact for parabolas. With w = h_n / h_{n-1},
///
///     1 / span = (1 + 2 w) / ((1 + w) h_n),      y_ref = ((1 + w)^2 y_n - w^2 y_{n-1}) / (1 + 2 w)
///
/// Steps that keep growing by w > 1 + sqrt(2) amplify errors without bound [Grigorieff1983]: a step that grows by more
/// is one of implicit Euler, as is the first one. Single steps of it do not change the order of a march.
/// @param dt         h_n > 0, s
/// @param dt_before  h_{n-1}, s; 0: there is no step before
inline BackwardDifference bdf2(double dt, double dt_before) {
  constexpr double largest_ratio = 1.0 + std::numbers::sqrt2;
  if (dt > largest_ratio * dt_before) return implicit_euler(dt);
  const double w = dt / dt_before;
  return {.span = (1.0 + w) / (1.0 + 2.0 * w) * dt,
          .now = (1.0 + w) * (1.0 + w) / (1.0 + 2.0 * w),
          .before = -w * w / (1.0 + 2.0 * w)};
}

}  // namespace bumpfoil
