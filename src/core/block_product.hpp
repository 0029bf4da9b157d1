#pragma once

#include <cstddef>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// y = K x, by code for blocks of B rows, or of any number: general products are slow for small blocks.
/// @param K  has the blocks of a BlockTridiagonal, of any type of matrix that is stored by columns
/// @param n  rows of a block
template <int B, typename Blocks>
void multiply_blocks(const Blocks& K, int n, const Vector& x, Vector& y) {
  const auto block = [n](const auto& matrix) {
    return Eigen::Map<const Eigen::Matrix<double, B, B>>(matrix.data(), n, n);
  };
  const auto part = [&](std::size_t b) { return x.segment<B>(static_cast<Eigen::Index>(b) * n, n); };
  for (std::size_t b = 0; b < K.diagonal.size(); ++b) {
    auto row = y.segment<B>(static_cast<Eigen::Index>(b) * n, n);
    row.noalias() = block(K.diagonal[b]) * part(b);
    if (b + 1 < K.diagonal.size()) row.noalias() += block(K.upper[b]) * part(b + 1);
    if (b > 0 && K.lower.empty()) row.noalias() += block(K.upper[b - 1]).transpose() * part(b - 1);
    if (b > 0 && !K.lower.empty()) row.noalias() += block(K.lower[b - 1]) * part(b - 1);
  }
}

}  // namespace bumpfoil
