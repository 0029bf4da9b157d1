#include "bumpfoil/core/block_tridiagonal.hpp"

#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "core/block_product.hpp"

namespace bumpfoil {

BlockTridiagonal::BlockTridiagonal(int blocks, int block_size)
    : diagonal(static_cast<std::size_t>(blocks), Matrix::Zero(block_size, block_size)),
      upper(static_cast<std::size_t>(blocks > 0 ? blocks - 1 : 0), Matrix::Zero(block_size, block_size)) {}

void BlockTridiagonal::add(int block_i, int i, int block_j, int j, double value) {
  if (block_i > block_j) {
    std::swap(block_i, block_j);
    std::swap(i, j);
  }
  BUMPFOIL_ASSERT(block_j - block_i <= 1 && is_symmetric());
  if (block_i == block_j) {
    Matrix& block = diagonal[static_cast<std::size_t>(block_i)];
    block(i, j) += value;
    if (i != j) block(j, i) += value;
  } else {
    upper[static_cast<std::size_t>(block_i)](i, j) += value;
  }
}

void BlockTridiagonal::append(const BlockTridiagonal& other) {
  BUMPFOIL_ASSERT(is_symmetric() && other.is_symmetric() && block_size() == other.block_size());
  upper.push_back(Matrix::Zero(block_size(), block_size()));
  upper.insert(upper.end(), other.upper.begin(), other.upper.end());
  diagonal.insert(diagonal.end(), other.diagonal.begin(), other.diagonal.end());
}

Vector BlockTridiagonal::multiply(const Vector& x) const {
  BUMPFOIL_ASSERT(x.size() == rows());
  Vector y(rows());
  switch (block_size()) {
    case 4:
      multiply_blocks<4>(*this, block_size(), x, y);
      break;
    case 6:
      multiply_blocks<6>(*this, block_size(), x, y);
      break;
    default:
      multiply_blocks<Eigen::Dynamic>(*this, block_size(), x, y);
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
      K.block(row + n, row, n, n) = is_symmetric() ? Matrix(upper[b].transpose()) : lower[b];
    }
  }
  return K;
}

}  // namespace bumpfoil
