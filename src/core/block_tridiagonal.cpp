#include "bumpfoil/core/block_tridiagonal.hpp"

#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

// Blocks are too small for general products of matrices of unknown size to pay: plain loops, with a length that the
// compiler knows for the sizes of the foil models.

/// y += a x
template <int B>
void add_product(const Matrix& a, const double* x, double* y) {
  const Eigen::Index n = B == Eigen::Dynamic ? a.rows() : B;
  const double* column = a.data();
  for (Eigen::Index c = 0; c < n; ++c, column += n) {
    for (Eigen::Index r = 0; r < n; ++r) y[r] += column[r] * x[c];
  }
}

/// y += a' x
template <int B>
void add_transposed_product(const Matrix& a, const double* x, double* y) {
  const Eigen::Index n = B == Eigen::Dynamic ? a.rows() : B;
  const double* column = a.data();
  for (Eigen::Index c = 0; c < n; ++c, column += n) {
    double sum = 0.0;
    for (Eigen::Index r = 0; r < n; ++r) sum += column[r] * x[r];
    y[c] += sum;
  }
}

/// y += K x
template <int B>
void add_product(const BlockTridiagonal& K, const double* x, double* y) {
  const int n = K.block_size();
  for (std::size_t b = 0; b < K.diagonal.size(); ++b, x += n, y += n) {
    add_product<B>(K.diagonal[b], x, y);
    if (b + 1 < K.diagonal.size()) add_product<B>(K.upper[b], x + n, y);
    if (b > 0) add_transposed_product<B>(K.upper[b - 1], x - n, y);
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
  Vector y = Vector::Zero(rows());
  switch (block_size()) {
    case 6:
      add_product<6>(*this, x.data(), y.data());
      break;
    case 11:
      add_product<11>(*this, x.data(), y.data());
      break;
    default:
      add_product<Eigen::Dynamic>(*this, x.data(), y.data());
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
