#include "bumpfoil/core/block_tridiagonal.hpp"

#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

BlockTridiagonal::BlockTridiagonal(int blocks, int block_size)
    : diagonal(static_cast<std::size_t>(blocks), Matrix::Zero(block_size, block_size)),
      upper(static_cast<std::size_t>(blocks > 0 ? blocks - 1 : 0), Matrix::Zero(block_size, block_size)) {}

void BlockTridiagonal::add(int block_i, int i, int block_j, int j, double value) {
  if (block_i > block_j) {
    std::swap(block_i, block_j);
    std::swap(i, j);
  }
  BUMPFOIL_ASSERT(block_j - block_i <= 1);
  if (block_i == block_j) {
    Matrix& block = diagonal[static_cast<std::size_t>(block_i)];
    block(i, j) += value;
    if (i != j) block(j, i) += value;
  } else {
    upper[static_cast<std::size_t>(block_i)](i, j) += value;
  }
}

Vector BlockTridiagonal::multiply(const Vector& x) const {
  BUMPFOIL_ASSERT(x.size() == rows());
  const int n = block_size();
  Vector y(rows());
  for (std::size_t b = 0; b < diagonal.size(); ++b) {
    const Eigen::Index row = static_cast<Eigen::Index>(b) * n;
    y.segment(row, n).noalias() = diagonal[b] * x.segment(row, n);
    if (b + 1 < diagonal.size()) y.segment(row, n).noalias() += upper[b] * x.segment(row + n, n);
    if (b > 0) y.segment(row, n).noalias() += upper[b - 1].transpose() * x.segment(row - n, n);
  }
  return y;
}

Matrix BlockTridiagonal::dense() const {
  const int n = block_size();
  Matrix K = Matrix::Zero(rows(), rows());
  for (std::size_t b = 0; b < diagonal.size(); ++b) {
    const Eigen::Index row = static_cast<Eigen::Index>(b) * n;
    K.block(row, row, n, n) = diagonal[b];
    if (b + 1 < diagonal.size()) {
      K.block(row, row + n, n, n) = upper[b];
      K.block(row + n, row, n, n) = upper[b].transpose();
    }
  }
  return K;
}

}  // namespace bumpfoil
