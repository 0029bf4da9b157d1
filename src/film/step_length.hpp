#pragma once

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Largest fraction of `step`, up to `fraction`, that leaves every entry of `value`, all positive, the part `kept` of
/// what it is.
inline double longest_fraction(const Matrix& value, const Matrix& step, double kept, double fraction) {
  const double deepest = (step.array() / value.array()).minCoeff();
  return deepest * fraction < kept - 1.0 ? (kept - 1.0) / deepest : fraction;
}

}  // namespace bumpfoil
