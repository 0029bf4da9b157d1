#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// LU factorisation of a general block-tridiagonal matrix by block elimination, pivoting inside the diagonal blocks
/// only: O(blocks) time and memory, no allocation after construction.
///
/// Pivoting inside the blocks suffices where every leading part of the matrix is itself a well-posed system; for foil
/// structures that part is the foil from the weld to a bump with the next bump held, with the same contact modes.
///
/// @tparam B rows per block, or Eigen::Dynamic.
template <int B>
class BlockTridiagonalLU {
 public:
  using Block = Eigen::Matrix<double, B, B, B == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

  BlockTridiagonalLU(int blocks, int block_size)
      : block_size_(block_size),
        lower_(static_cast<std::size_t>(blocks), Block::Zero(block_size, block_size)),
        diagonal_(lower_),
        upper_(lower_),
        factors_(lower_),
        reduced_upper_(lower_),
        pivot_rows_(static_cast<std::size_t>(blocks) * static_cast<std::size_t>(block_size)) {}

  [[nodiscard]] int blocks() const { return static_cast<int>(diagonal_.size()); }

  /// The matrix to be factored, block by block: (i, i-1), (i, i), (i, i+1). The first lower and the last upper block
  /// are not read.
  Block& lower(int i) { return lower_[static_cast<std::size_t>(i)]; }
  Block& diagonal(int i) { return diagonal_[static_cast<std::size_t>(i)]; }
  Block& upper(int i) { return upper_[static_cast<std::size_t>(i)]; }

  /// Factors the matrix. Blocks before `first` must be as they were at the last factorisation: their part is kept.
  /// @return false if a pivot was zero or not finite (a long foil nearly floats, so that tiny ones are no error); the
  /// factors are then unusable.
  [[nodiscard]] bool factor(int first = 0) {
    for (auto i = static_cast<std::size_t>(first); i < diagonal_.size(); ++i) {
      factors_[i] = diagonal_[i];
      if (i > 0) subtract_sparse_product(lower_[i], reduced_upper_[i - 1], factors_[i]);
      if (!factor_block(i)) return false;
      if (i + 1 < diagonal_.size()) {
        reduced_upper_[i] = upper_[i];
        solve_block(i, reduced_upper_[i]);
      }
    }
    return true;
  }

  /// Overwrites the right-hand side `x` by the solution.
  void solve_in_place(Vector& x) const {
    const Eigen::Index n = size();
    BUMPFOIL_ASSERT(x.size() == blocks() * n);
    double* part = x.data();
    for (std::size_t i = 0; i < factors_.size(); ++i, part += n) {
      if (i > 0) subtract_product(lower_[i], part - n, part);
      solve_block(i, part);
    }
    part -= n;
    for (std::size_t i = factors_.size() - 1; i-- > 0;) {
      part -= n;
      subtract_product(reduced_upper_[i], part + n, part);
    }
  }

  /// Solves for as many right-hand sides as a block has columns, `right` in the rows of `block` and zero elsewhere.
  /// @param solution  receives the blocks of the solution; holds blocks() blocks of the right size
  void solve_block_column(int block, const Block& right, std::vector<Block>& solution) const {
    const auto start = static_cast<std::size_t>(block);
    BUMPFOIL_ASSERT(solution.size() == factors_.size() && start < factors_.size());
    for (std::size_t i = 0; i < start; ++i) solution[i].setZero();
    solution[start] = right;
    solve_block(start, solution[start]);
    for (std::size_t i = start + 1; i < factors_.size(); ++i) {
      solution[i].setZero();
      subtract_sparse_product(lower_[i], solution[i - 1], solution[i]);
      solve_block(i, solution[i]);
    }
    for (std::size_t i = factors_.size() - 1; i-- > 0;) {
      subtract_product(reduced_upper_[i], solution[i + 1], solution[i]);
    }
  }

 private:
  // Plain loops over a number of rows that the compiler knows: for blocks of ten rows they leave the general
  // factorisations and products of a matrix library behind by a factor of about four.

  [[nodiscard]] Eigen::Index size() const { return B == Eigen::Dynamic ? block_size_ : B; }

  /// row -= sum over k < count of factors[k] * (row k of `rows`), all rows as long as a block. Known lengths are summed
  /// in registers.
  void subtract_rows(const double* factors, const double* rows, Eigen::Index count, double* row) const {
    if constexpr (B == Eigen::Dynamic) {
      for (Eigen::Index k = 0; k < count; ++k) {
        for (Eigen::Index c = 0; c < block_size_; ++c) row[c] -= factors[k] * rows[k * block_size_ + c];
      }
    } else {
      double sum[B];
      for (Eigen::Index c = 0; c < B; ++c) sum[c] = row[c];
      for (Eigen::Index k = 0; k < count; ++k) {
        for (Eigen::Index c = 0; c < B; ++c) sum[c] -= factors[k] * rows[k * B + c];
      }
      for (Eigen::Index c = 0; c < B; ++c) row[c] = sum[c];
    }
  }

  /// result -= a * b
  void subtract_product(const Block& a, const Block& b, Block& result) const {
    const Eigen::Index n = size();
    for (Eigen::Index r = 0; r < n; ++r) subtract_rows(a.data() + r * n, b.data(), n, result.data() + r * n);
  }

  /// result -= a * b where most of a is zero, as couplings of neighbouring blocks are. In large blocks that is worth a
  /// look at every entry.
  void subtract_sparse_product(const Block& a, const Block& b, Block& result) const {
    if constexpr (B != Eigen::Dynamic && B < 12) return subtract_product(a, b, result);
    const Eigen::Index n = size();
    for (Eigen::Index r = 0; r < n; ++r) {
      const double* factors = a.data() + r * n;
      double* row = result.data() + r * n;
      for (Eigen::Index k = 0; k < n; ++k) {
        if (factors[k] == 0.0) continue;
        for (Eigen::Index c = 0; c < n; ++c) row[c] -= factors[k] * b.data()[k * n + c];
      }
    }
  }

  /// y -= a x
  void subtract_product(const Block& a, const double* x, double* y) const {
    const Eigen::Index n = size();
    for (Eigen::Index r = 0; r < n; ++r) {
      double sum = 0.0;
      for (Eigen::Index c = 0; c < n; ++c) sum += a.data()[r * n + c] * x[c];
      y[r] -= sum;
    }
  }

  /// LU factors of block i in place with row exchanges; the diagonal keeps the inverse pivots.
  bool factor_block(std::size_t i) {
    const Eigen::Index n = size();
    double* a = factors_[i].data();
    int* pivot_row = pivot_rows_.data() + i * static_cast<std::size_t>(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      Eigen::Index best = k;
      for (Eigen::Index r = k + 1; r < n; ++r) {
        if (std::abs(a[r * n + k]) > std::abs(a[best * n + k])) best = r;
      }
      pivot_row[k] = static_cast<int>(best);
      if (best != k) std::swap_ranges(a + k * n, a + (k + 1) * n, a + best * n);
      const double pivot = a[k * n + k];
      if (pivot == 0.0 || !std::isfinite(pivot)) return false;
      a[k * n + k] = 1.0 / pivot;
      for (Eigen::Index r = k + 1; r < n; ++r) {
        const double factor = a[r * n + k] *= a[k * n + k];
        for (Eigen::Index c = k + 1; c < n; ++c) a[r * n + c] -= factor * a[k * n + c];
      }
    }
    return true;
  }

  /// X = (block i)^-1 X with the factors of block i.
  void solve_block(std::size_t i, Block& X) const {
    const Eigen::Index n = size();
    const double* a = factors_[i].data();
    const int* pivot_row = pivot_rows_.data() + i * static_cast<std::size_t>(n);
    double* x = X.data();
    for (Eigen::Index k = 0; k < n; ++k) {
      if (pivot_row[k] != k) std::swap_ranges(x + k * n, x + (k + 1) * n, x + pivot_row[k] * n);
    }
    for (Eigen::Index r = 1; r < n; ++r) subtract_rows(a + r * n, x, r, x + r * n);
    for (Eigen::Index r = n - 1; r >= 0; --r) {
      subtract_rows(a + r * n + r + 1, x + (r + 1) * n, n - 1 - r, x + r * n);
      for (Eigen::Index c = 0; c < n; ++c) x[r * n + c] *= a[r * n + r];
    }
  }

  /// The same for a vector.
  void solve_block(std::size_t i, double* x) const {
    const Eigen::Index n = size();
    const double* a = factors_[i].data();
    const int* pivot_row = pivot_rows_.data() + i * static_cast<std::size_t>(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      if (pivot_row[k] != k) std::swap(x[k], x[pivot_row[k]]);
    }
    for (Eigen::Index r = 1; r < n; ++r) {
      for (Eigen::Index k = 0; k < r; ++k) x[r] -= a[r * n + k] * x[k];
    }
    for (Eigen::Index r = n - 1; r >= 0; --r) {
      for (Eigen::Index k = r + 1; k < n; ++k) x[r] -= a[r * n + k] * x[k];
      x[r] *= a[r * n + r];
    }
  }

  int block_size_;
  std::vector<Block> lower_, diagonal_, upper_;
  std::vector<Block> factors_;        ///< of the diagonal blocks once those before are eliminated
  std::vector<Block> reduced_upper_;  ///< inverse of the reduced diagonal block times the upper one
  std::vector<int> pivot_rows_;       ///< row that was exchanged with each row of a block
};

}  // namespace bumpfoil
