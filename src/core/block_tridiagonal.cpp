#include "bumpfoil/core/block_tridiagonal.hpp"

#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

// Blocks are too small for general products of matrices of unknown size to pay.

/// y += a x
void add_product(const Matrix& a, const double* x, double* y) {
  const double* entry = a.data();  // column by column
  for (Eigen::Index c = 0; c < a.cols(); ++c) {
    for (Eigen::Index r = 0; r < a.rows(); ++r) y[r] += *entry++ * x[c];
  }
}

/// y += a' x
void add_transposed_product(const Matrix& a, const double* x, double* y) {
  const double* entry = a.data();
  for (Eigen::Index c = 0; c < a.cols(); ++c) {
    for (Eigen::Index r = 0; r < a.rows(); ++r) y[c] += *entry++ * x[r];
  }
}

}  // namespace

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
  Vector y = Vector::Zero(rows());
  for (std::size_t b = 0; b < diagonal.size(); ++b) {
    const double* xb = x.data() + static_cast<Eigen::Index>(b) * n;
    double* yb = y.data() + static_cast<Eigen::Index>(b) * n;
    add_product(diagonal[b], xb, yb);
    if (b + 1 == diagonal.size()) break;
    add_product(upper[b], xb + n, yb);
    add_transposed_product(upper[b], xb, yb + n);
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
