#pragma once

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// LU factorisation of a general block-tridiagonal matrix by block elimination, pivoting inside the diagonal blocks
/// only: O(blocks) time and memory, and no allocation after construction where B is fixed.
///
/// Pivoting inside the blocks suffices where every leading part of the matrix is itself a well-posed system; for foil
/// structures that part is the foil from the weld to a bump with the next bump held, with the same contact modes.
///
/// @tparam B rows per block, or Eigen::Dynamic.
template <int B>
class BlockTridiagonalLU {
 public:
  using Block = Eigen::Matrix<double, B, B>;

  BlockTridiagonalLU(int blocks, int block_size)
      : block_size_(block_size),
        lower_(static_cast<std::size_t>(blocks), Block::Zero(block_size, block_size)),
        diagonal_(lower_),
        upper_(lower_),
        reduced_upper_(lower_),
        pivots_(static_cast<std::size_t>(blocks), Eigen::PartialPivLU<Block>(Block::Identity(block_size, block_size))) {
  }

  [[nodiscard]] int blocks() const { return static_cast<int>(diagonal_.size()); }

  /// The matrix to be factored, block by block: (i, i-1), (i, i), (i, i+1). The first lower and the last upper block
  /// are not read.
  Block& lower(int i) { return lower_[static_cast<std::size_t>(i)]; }
  Block& diagonal(int i) { return diagonal_[static_cast<std::size_t>(i)]; }
  Block& upper(int i) { return upper_[static_cast<std::size_t>(i)]; }

  /// Factors the matrix. Blocks before `first` must be as they were at the last factorisation: their part is kept.
  /// @return false if a pivot vanished or was not finite; the factors are then unusable.
  [[nodiscard]] bool factor(int first = 0) {
    for (auto i = static_cast<std::size_t>(first); i < diagonal_.size(); ++i) {
      Block reduced = diagonal_[i];
      if (i > 0) reduced.noalias() -= lower_[i] * reduced_upper_[i - 1];
      pivots_[i].compute(reduced);
      const double product = pivots_[i].matrixLU().diagonal().cwiseAbs().minCoeff();
      if (!(product > 0.0) || !std::isfinite(product)) return false;
      if (i + 1 < diagonal_.size()) reduced_upper_[i].noalias() = pivots_[i].solve(upper_[i]);
    }
    return true;
  }

  /// Overwrites the right-hand side `x` by the solution.
  void solve_in_place(Vector& x) const {
    const Eigen::Index n = block_size_;
    const auto last = static_cast<Eigen::Index>(diagonal_.size()) - 1;
    BUMPFOIL_ASSERT(x.size() == (last + 1) * n);
    Eigen::Matrix<double, B, 1> part(n);
    for (Eigen::Index i = 0; i <= last; ++i) {
      const auto k = static_cast<std::size_t>(i);
      part = segment(x, i);
      if (i > 0) part.noalias() -= lower_[k] * segment(x, i - 1);
      segment(x, i).noalias() = pivots_[k].solve(part);
    }
    for (Eigen::Index i = last - 1; i >= 0; --i) {
      segment(x, i).noalias() -= reduced_upper_[static_cast<std::size_t>(i)] * segment(x, i + 1);
    }
  }

 private:
  auto segment(Vector& x, Eigen::Index i) const { return x.segment<B>(i * block_size_, block_size_); }

  int block_size_;
  std::vector<Block> lower_, diagonal_, upper_;
  std::vector<Block> reduced_upper_;  ///< inverse of the reduced diagonal block times the upper one
  std::vector<Eigen::PartialPivLU<Block>> pivots_;
};

}  // namespace bumpfoil
