#include "bumpfoil/core/block_tridiagonal.hpp"

#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// y = K x with fixed block sizes: general products are slow for such small blocks.
template <int B>
void multiply(const BlockTridiagonal& K, const Vector& x, Vector& y) {
  using Block = Eigen::Map<const Eigen::Matrix<double, B, B>>;
  const int n = K.block_size();
  const auto block = [n](const Matrix& matrix) { return Block(matrix.data(), n, n); };
  const auto part = [&](std::size_t b) { return x.segment<B>(static_cast<Eigen::Index>(b) * n, n); };
  for (std::size_t b = 0; b < K.diagonal.size(); ++b) {
    auto row = y.segment<B>(static_cast<Eigen::Index>(b) * n, n);
    row.noalias() = block(K.diagonal[b]) * part(b);
    if (b + 1 < K.diagonal.size()) row.noalias() += block(K.upper[b]) * part(b + 1);
    if (b == 0) continue;
    if (K.is_symmetric()) {
      row.noalias() += block(K.upper[b - 1]).transpose() * part(b - 1);
    } else {
      row.noalias() += block(K.lower[b - 1]) * part(b - 1);
    }
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
      bumpfoil::multiply<4>(*this, x, y);
      break;
    case 6:
      bumpfoil::multiply<6>(*this, x, y);
      break;
    case 11:
      bumpfoil::multiply<11>(*this, x, y);
      break;
    default:
      bumpfoil::multiply<Eigen::Dynamic>(*this, x, y);
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
