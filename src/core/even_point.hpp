#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

namespace bumpfoil {

/// Point k of a low-discrepancy sequence in the unit box: additive recurrence with the powers of the root of x^(n+1) =
/// x + 1. @param shift  added to each coordinate, modulo 1
inline Eigen::VectorXd even_point(std::size_t k, const Eigen::VectorXd& shift) {
  const auto n = static_cast<double>(shift.size());
  double root = 1.5;
  for (int i = 0; i < 50; ++i) root = std::pow(1.0 + root, 1.0 / (n + 1.0));
  Eigen::VectorXd x(shift.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double along = 0.5 + shift[i] + static_cast<double>(k) * std::pow(root, -static_cast<double>(i + 1));
    x[i] = along - std::floor(along);
  }
  return x;
}

}  // namespace bumpfoil
