#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>
#include <vector>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/core/dense_kernels.hpp"

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

  /// @param instructions  that this processor has; small blocks gain nothing by them
  BlockTridiagonalLU(int blocks, int block_size, VectorInstructions instructions = widest_vector_instructions())
      : block_size_(block_size),
        instructions_(has_wide_rows<B> ? instructions : VectorInstructions::baseline),
        lower_(static_cast<std::size_t>(blocks), Block::Zero(block_size, block_size)),
        diagonal_(lower_),
        upper_(lower_),
        factors_(static_cast<std::size_t>(blocks * block_size * stride())),
        reduced_upper_(factors_),
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
    return with_kernels([&](const auto& kernels) BUMPFOIL_ALWAYS_INLINE {
      for (int i = first; i < blocks(); ++i) {
        copy(diagonal_[place(i)], factors(i));
        if (i > 0) subtract_lower(kernels, i, reduced_upper(i - 1), factors(i));
        if (!kernels.factor(factors(i), pivots(i))) return false;
        if (i + 1 == blocks()) break;
        copy(upper_[place(i)], reduced_upper(i));
        kernels.solve(factors(i), pivots(i), reduced_upper(i));
      }
      return true;
    });
  }

  /// Overwrites the right-hand side `x` by the solution.
  void solve_in_place(Vector& x) const {
    const Eigen::Index n = size();
    BUMPFOIL_ASSERT(x.size() == blocks() * n);
    double* part = x.data();
    for (int i = 0; i < blocks(); ++i, part += n) {
      if (i > 0) subtract_product(lower_[place(i)].data(), n, part - n, part);
      solve_block(i, part);
    }
    part -= n;
    for (int i = blocks() - 1; i-- > 0;) {
      part -= n;
      subtract_product(reduced_upper(i), stride(), part + n, part);
    }
  }

  /// The same for many right-hand sides, side by side in a matrix that is stored by rows.
  template <typename Panel>
  void solve_panel_in_place(Panel& X) const {
    static_assert(Panel::IsRowMajor);
    const Eigen::Index n = size();
    BUMPFOIL_ASSERT(X.rows() == blocks() * n);
    const Eigen::Index columns = X.cols();
    // Row of X -= sum over k < count of factors[k] (row k behind `rows`).
    const auto subtract = [columns](const double* factors, Eigen::Index count, const double* rows, double* row) {
      add_rows(-1.0, factors, 1, count, rows, columns, row);
    };
    double* part = X.data();
    for (int i = 0; i < blocks(); ++i, part += n * columns) {
      const double* coupling = lower_[place(i)].data();
      const double* a = factors(i);
      for (Eigen::Index r = 0; i > 0 && r < n; ++r) {
        subtract(coupling + r * n, n, part - n * columns, part + r * columns);
      }
      for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::Index other = pivots(i)[k];
        if (other != k) std::swap_ranges(part + k * columns, part + (k + 1) * columns, part + other * columns);
      }
      for (Eigen::Index r = 1; r < n; ++r) subtract(a + r * stride(), r, part, part + r * columns);
      for (Eigen::Index r = n - 1; r >= 0; --r) {
        subtract(a + r * stride() + r + 1, n - r - 1, part + (r + 1) * columns, part + r * columns);
        for (Eigen::Index c = 0; c < columns; ++c) part[r * columns + c] *= a[r * stride() + r];
      }
    }
    part -= n * columns;
    for (int i = blocks() - 1; i-- > 0;) {
      part -= n * columns;
      for (Eigen::Index r = 0; r < n; ++r) {
        subtract(reduced_upper(i) + r * stride(), n, part + n * columns, part + r * columns);
      }
    }
  }

  /// Solves for as many right-hand sides as a block has columns, `right` in the rows of `block` and zero elsewhere.
  /// @param answer  receives the blocks of the solution; holds blocks() blocks of the right size
  void solve_block_column(int block, const Block& right, std::vector<Block>& answer) {
    BUMPFOIL_ASSERT(answer.size() == diagonal_.size() && block < blocks());
    answer_.assign(factors_.size(), 0.0);
    const auto part = [&](int i) { return answer_.data() + i * size() * stride(); };
    copy(right, part(block));
    with_kernels([&](const auto& kernels) BUMPFOIL_ALWAYS_INLINE {
      kernels.solve(factors(block), pivots(block), part(block));
      for (int i = block + 1; i < blocks(); ++i) {
        subtract_lower(kernels, i, part(i - 1), part(i));
        kernels.solve(factors(i), pivots(i), part(i));
      }
      for (int i = blocks() - 1; i-- > 0;) {
        kernels.products(reduced_upper(i), stride(), part(i + 1), size(), part(i), size());
      }
      return true;
    });
    for (int i = 0; i < blocks(); ++i) {
      for (Eigen::Index r = 0; r < size(); ++r) {
        std::copy_n(part(i) + r * stride(), size(), answer[place(i)].data() + r * size());
      }
    }
  }

 private:
  static std::size_t place(int block) { return static_cast<std::size_t>(block); }

  [[nodiscard]] Eigen::Index size() const { return B == Eigen::Dynamic ? block_size_ : B; }
  [[nodiscard]] Eigen::Index stride() const { return row_stride<B>(block_size_); }

  /// Blocks of the factors: rows of stride() numbers.
  double* factors(int i) { return factors_.data() + i * size() * stride(); }
  double* reduced_upper(int i) { return reduced_upper_.data() + i * size() * stride(); }
  int* pivots(int i) { return pivot_rows_.data() + i * size(); }
  [[nodiscard]] const double* factors(int i) const { return factors_.data() + i * size() * stride(); }
  [[nodiscard]] const double* reduced_upper(int i) const { return reduced_upper_.data() + i * size() * stride(); }
  [[nodiscard]] const int* pivots(int i) const { return pivot_rows_.data() + i * size(); }

  /// Calls body(kernels) compiled for the instructions that were requested.
  template <typename Body>
  bool with_kernels(Body&& body) const {
    if constexpr (has_wide_rows<B>) {
      return with_vectors(instructions_, [&](auto lanes) BUMPFOIL_ALWAYS_INLINE {
        return body(DenseKernels<B, decltype(lanes)::value>(block_size_));
      });
    } else {
      return body(DenseKernels<B, 2>(block_size_));
    }
  }

  BUMPFOIL_ALWAYS_INLINE void copy(const Block& from, double* to) const {
    for (Eigen::Index r = 0; r < size(); ++r) {
      for (Eigen::Index c = 0; c < size(); ++c) to[r * stride() + c] = from.data()[r * size() + c];
    }
  }

  /// result -= lower(i) * block. Couplings of neighbouring blocks are mostly zero; in large blocks that is worth a
  /// look.
  template <typename Kernels>
  BUMPFOIL_ALWAYS_INLINE void subtract_lower(const Kernels& kernels, int i, const double* block, double* result) const {
    constexpr bool large = B == Eigen::Dynamic || B >= 12;
    kernels.template products<Products::subtract, large>(lower_[place(i)].data(), size(), block, size(), result,
                                                         size());
  }

  /// y -= a x
  void subtract_product(const double* a, Eigen::Index row, const double* x, double* y) const {
    const Eigen::Index n = size();
    for (Eigen::Index r = 0; r < n; ++r) {
      double sum = 0.0;
      for (Eigen::Index c = 0; c < n; ++c) sum += a[r * row + c] * x[c];
      y[r] -= sum;
    }
  }

  /// x = (block i)^-1 x with the factors of block i.
  void solve_block(int i, double* x) const {
    const Eigen::Index n = size();
    const double* a = factors(i);
    const int* pivot = pivots(i);
    for (Eigen::Index k = 0; k < n; ++k) {
      if (pivot[k] != k) std::swap(x[k], x[pivot[k]]);
    }
    for (Eigen::Index r = 1; r < n; ++r) {
      for (Eigen::Index k = 0; k < r; ++k) x[r] -= a[r * stride() + k] * x[k];
    }
    for (Eigen::Index r = n - 1; r >= 0; --r) {
      for (Eigen::Index k = r + 1; k < n; ++k) x[r] -= a[r * stride() + k] * x[k];
      x[r] *= a[r * stride() + r];
    }
  }

  int block_size_;
  VectorInstructions instructions_;
  std::vector<Block> lower_, diagonal_, upper_;
  LineVector factors_;           ///< of the diagonal blocks once those before are eliminated
  LineVector reduced_upper_;     ///< inverse of the reduced diagonal block times the upper one
  LineVector answer_;            ///< of solve_block_column()
  std::vector<int> pivot_rows_;  ///< row that was exchanged with each row of a block
};

}  // namespace bumpfoil
