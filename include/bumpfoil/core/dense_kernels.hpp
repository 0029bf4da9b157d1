#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "bumpfoil/core/vector_instructions.hpp"

namespace bumpfoil {

/// Numbers from the beginning of a cache line on, which no vector then straddles.
template <typename Number>
struct LineAllocator {
  using value_type = Number;  // NOLINT(readability-identifier-naming): the standard's name
  static constexpr std::align_val_t alignment{64};

  LineAllocator() = default;
  template <typename Other>
  explicit LineAllocator(const LineAllocator<Other>& /*other*/) {}

  Number* allocate(std::size_t count) {
    return static_cast<Number*>(::operator new(count * sizeof(Number), alignment));
  }
  void deallocate(Number* numbers, std::size_t /*count*/) { ::operator delete(numbers, alignment); }
  friend bool operator==(const LineAllocator& /*a*/, const LineAllocator& /*b*/) { return true; }
};
using LineVector = std::vector<double, LineAllocator<double>>;

/// Numbers that one instruction takes. Spelled out: where the length depends on a template's parameter, g++ 12 forgets
/// the attribute.
template <int Width>
struct VectorOf;
template <>
struct VectorOf<1> {
  using Type = double;
};
template <>
struct VectorOf<2> {
  using Type = double __attribute__((vector_size(16)));
};
template <>
struct VectorOf<4> {
  using Type = double __attribute__((vector_size(32)));
};
template <>
struct VectorOf<8> {
  using Type = double __attribute__((vector_size(64)));
};

/// Whether wide vectors pay for blocks of B rows.
template <int B>
inline constexpr bool has_wide_rows = B == Eigen::Dynamic || B >= 8;

/// From one row of a block for DenseKernels to the next: whole vectors.
template <int B>
constexpr Eigen::Index row_stride(Eigen::Index n) {
  if (B == Eigen::Dynamic) return n;
  return has_wide_rows<B> ? (B + 7) / 8 * 8 : (B + 1) / 2 * 2;
}

/// What is done with the products that a loop of DenseKernels sums.
enum class Products {
  subtract,  ///< target -= products
  assign,    ///< target = products
  negate,    ///< target = -products
};

namespace detail {
/// In place of what is not there.
struct Nothing {};
}  // namespace detail

/// N numbers in registers. One vector and the rest, as g++ 12 keeps arrays of them in memory.
template <int N, int Width>
struct RegisterRow {
  static constexpr int width = N < Width ? 1 : Width;
  static_assert(N % width == 0);

  BUMPFOIL_ALWAYS_INLINE void load(const double* from) {
    std::memcpy(&head, from, sizeof head);
    if constexpr (N > width) tail.load(from + width);
  }
  BUMPFOIL_ALWAYS_INLINE void store(double* to) const {
    std::memcpy(to, &head, sizeof head);
    if constexpr (N > width) tail.store(to + width);
  }
  template <Products Use>
  BUMPFOIL_ALWAYS_INLINE void begin(const double* target) {
    if constexpr (Use == Products::subtract) {
      load(target);
    } else {
      head = typename VectorOf<width>::Type{};
      if constexpr (N > width) tail.template begin<Use>(target);
    }
  }
  template <Products Use>
  BUMPFOIL_ALWAYS_INLINE void use(double factor, const RegisterRow& other) {
    if constexpr (Use == Products::assign) {
      head += factor * other.head;
    } else {
      head -= factor * other.head;
    }
    if constexpr (N > width) tail.template use<Use>(factor, other.tail);
  }
  template <Products Use>
  BUMPFOIL_ALWAYS_INLINE void use_each(const RegisterRow& a, const RegisterRow& b) {
    if constexpr (Use == Products::assign) {
      head += a.head * b.head;
    } else {
      head -= a.head * b.head;
    }
    if constexpr (N > width) tail.template use_each<Use>(a.tail, b.tail);
  }

  typename VectorOf<width>::Type head;
  std::conditional_t<(N > width), RegisterRow<(N > width ? N - width : width), Width>, detail::Nothing> tail;
};

/// Rows of N numbers in registers, `Together` of them: a part of a product while it is added up.
template <int N, int Together, int Width>
struct RegisterSums {
  template <Products Use>
  BUMPFOIL_ALWAYS_INLINE void begin(const double* targets, Eigen::Index stride) {
    head.template begin<Use>(targets);
    if constexpr (Together > 1) tail.template begin<Use>(targets + stride, stride);
  }
  BUMPFOIL_ALWAYS_INLINE void store(double* to, Eigen::Index stride) const {
    head.store(to);
    if constexpr (Together > 1) tail.store(to + stride, stride);
  }
  template <Products Use>
  BUMPFOIL_ALWAYS_INLINE void use(const double* factors, Eigen::Index stride, const RegisterRow<N, Width>& row) {
    head.template use<Use>(*factors, row);
    if constexpr (Together > 1) tail.template use<Use>(factors + stride, stride, row);
  }

  RegisterRow<N, Width> head;
  std::conditional_t<(Together > 1), RegisterSums<N, (Together > 1 ? Together - 1 : 1), Width>, detail::Nothing> tail;
};

/// Inner loops over dense blocks of n rows, to be called from the body of with_vectors(). A row holds n numbers and
/// zeros up to row_stride(n). Blocks may be stored by columns as well: then "row" reads "column" throughout.
///
/// @tparam B      n, or Eigen::Dynamic
/// @tparam Width  numbers in a vector
template <int B, int Width>
class DenseKernels {
 public:
  explicit BUMPFOIL_ALWAYS_INLINE DenseKernels(Eigen::Index n) : n_(n) {}

  [[nodiscard]] BUMPFOIL_ALWAYS_INLINE Eigen::Index size() const { return B == Eigen::Dynamic ? n_ : B; }
  [[nodiscard]] BUMPFOIL_ALWAYS_INLINE Eigen::Index stride() const { return row_stride<B>(n_); }

  /// targets[t] -= sum over k < count of factors[t][k] * rows[k], or another use of them, for `rows_changed` targets.
  /// @tparam Sparse         most factors are zero, which is worth a look at every one
  /// @param factors_stride  from the factors of one target to those of the next
  template <Products Use = Products::subtract, bool Sparse = false>
  BUMPFOIL_ALWAYS_INLINE void products(const double* factors, Eigen::Index factors_stride, const double* rows,
                                       Eigen::Index count, double* targets, Eigen::Index rows_changed) const {
    for_each_part([&](auto length, Eigen::Index first) BUMPFOIL_ALWAYS_INLINE {
      constexpr int N = decltype(length)::value;
      constexpr int together = rows_together(N);
      Eigen::Index t = 0;
      for (; t + together <= rows_changed; t += together) {
        products_of_part<N, together, Use, Sparse>(factors + t * factors_stride, factors_stride, rows + first, count,
                                                   targets + t * stride() + first);
      }
      for (; t < rows_changed; ++t) {
        products_of_part<N, 1, Use, Sparse>(factors + t * factors_stride, factors_stride, rows + first, count,
                                            targets + t * stride() + first);
      }
    });
  }

  /// The same of one row, number by number, and of multiples of some more: target -= a * row + sum factors[i] *
  /// more[i].
  /// @tparam Count  of those, or Eigen::Dynamic
  /// @param more    each a stride() behind the one before
  template <Products Use = Products::subtract, int Count = Eigen::Dynamic>
  BUMPFOIL_ALWAYS_INLINE void products_of_row(const double* a, const double* row, const double* factors,
                                              const double* more, Eigen::Index count, double* target) const {
    for_each_part([&](auto length, Eigen::Index first) BUMPFOIL_ALWAYS_INLINE {
      Row<decltype(length)::value> sum, one, other;
      sum.template begin<Use>(target + first);
      one.load(a + first);
      other.load(row + first);
      sum.template use_each<Use>(one, other);
      const Eigen::Index rows = Count == Eigen::Dynamic ? count : Count;
      for (Eigen::Index i = 0; i < rows; ++i) {
        other.load(more + i * stride() + first);
        sum.template use<Use>(factors[i], other);
      }
      sum.store(target + first);
    });
  }

  /// Overwrites a block by its LU factors with row exchanges; the diagonal keeps the inverse pivots.
  /// @param pivots  receives the row that was exchanged with each
  /// @return false if a pivot was zero or not finite
  [[nodiscard]] BUMPFOIL_ALWAYS_INLINE bool factor(double* a, int* pivots) const {
    for (Eigen::Index k = 0; k < size(); ++k) {
      double* row = a + k * stride();
      if (!exchange_rows(a, k, pivots)) return false;
      const double inverse = row[k] = 1.0 / row[k];
      if constexpr (B == Eigen::Dynamic || !has_wide_rows<B>) {
        for (Eigen::Index r = k + 1; r < size(); ++r) {
          const double factor = a[r * stride() + k] *= inverse;
          for (Eigen::Index c = k + 1; c < size(); ++c) a[r * stride() + c] -= factor * row[c];
        }
      } else {
        // Whole rows, of which the part that is finished stays as it is.
        alignas(64) double rest[row_stride<B>(B)];
        for (Eigen::Index c = 0; c < stride(); ++c) rest[c] = c > k ? row[c] : 0.0;
        Row<rounded> own;
        own.load(rest);
        for (Eigen::Index r = k + 1; r < B; ++r) {
          const double factor = a[r * stride() + k] * inverse;
          Row<rounded> other;
          other.load(a + r * stride());
          other.template use<Products::subtract>(factor, own);
          other.store(a + r * stride());
          a[r * stride() + k] = factor;
        }
      }
    }
    return true;
  }

  /// Overwrites the block x by the solution of the factored block times it.
  BUMPFOIL_ALWAYS_INLINE void solve(const double* factors, const int* pivots, double* x) const {
    const Eigen::Index n = size();
    const Eigen::Index s = stride();
    for (Eigen::Index k = 0; k < n; ++k) {
      if (pivots[k] != k) std::swap_ranges(x + k * s, x + (k + 1) * s, x + pivots[k] * s);
    }
    for (Eigen::Index begin = 0; begin < n; begin += group) {
      const Eigen::Index end = std::min(begin + group, n);
      products(factors + begin * s, s, x, begin, x + begin * s, end - begin);
      for (Eigen::Index r = begin + 1; r < end; ++r) {
        products(factors + r * s + begin, s, x + begin * s, r - begin, x + r * s, 1);
      }
    }
    for (Eigen::Index end = n; end > 0; end -= std::min(group, end)) {
      const Eigen::Index begin = std::max<Eigen::Index>(end - group, 0);
      products(factors + begin * s + end, s, x + end * s, n - end, x + begin * s, end - begin);
      for (Eigen::Index r = end; r-- > begin;) {
        products(factors + r * s + r + 1, s, x + (r + 1) * s, end - 1 - r, x + r * s, 1);
        for (Eigen::Index c = 0; c < s; ++c) x[r * s + c] *= factors[r * s + r];
      }
    }
  }

  /// Overwrites a block by its inverse: elimination with row exchanges.
  /// @param factors  room for n numbers
  /// @param pivots   receives the row that was exchanged with each
  /// @return false if a pivot was zero or not finite
  [[nodiscard]] BUMPFOIL_ALWAYS_INLINE bool invert(double* a, double* factors, int* pivots) const {
    const Eigen::Index n = size();
    const Eigen::Index s = stride();
    for (Eigen::Index k = 0; k < n; ++k) {
      double* row = a + k * s;
      if (!exchange_rows(a, k, pivots)) return false;
      const double inverse = 1.0 / row[k];
      row[k] = 1.0;
      for (Eigen::Index c = 0; c < s; ++c) row[c] *= inverse;
      for (Eigen::Index r = 0; r < n; ++r) factors[r] = r == k ? 0.0 : std::exchange(a[r * s + k], 0.0);
      for_each_part([&](auto length, Eigen::Index first) BUMPFOIL_ALWAYS_INLINE {
        Row<decltype(length)::value> own, other;
        own.load(row + first);
        for (Eigen::Index r = 0; r < n; ++r) {
          other.load(a + r * s + first);
          other.template use<Products::subtract>(factors[r], own);
          other.store(a + r * s + first);
        }
      });
    }
    for (Eigen::Index k = n; k-- > 0;) {
      if (pivots[k] == k) continue;
      for (Eigen::Index r = 0; r < n; ++r) std::swap(a[r * s + k], a[r * s + pivots[k]]);
    }
    return true;
  }

 private:
  /// Rows that solve() treats as one.
  static constexpr Eigen::Index group = has_wide_rows<B> ? 4 : 1;
  /// A row in whole vectors.
  static constexpr int rounded = B == Eigen::Dynamic ? 0 : (B + Width - 1) / Width * Width;

  template <int N>
  using Row = RegisterRow<N, Width>;
  template <int N, int Together>
  using Sums = RegisterSums<N, Together, Width>;

  /// How many rows of N numbers leave room in the registers for what they are added up from.
  static constexpr int rows_together(int N) {
    const int vectors = (N + Width - 1) / Width;
    const int registers = Width == 8 ? 32 : 16;
    return std::clamp((registers - 2 - vectors) / vectors, 1, static_cast<int>(group));
  }

  /// Calls visit(Lanes<length>(), first) for the parts of a row that fit into registers.
  template <typename Visitor>
  BUMPFOIL_ALWAYS_INLINE void for_each_part(Visitor&& visit) const {
    if constexpr (B != Eigen::Dynamic) {
      visit(Lanes<rounded>(), Eigen::Index{0});
    } else {
      Eigen::Index first = 0;
      for (; first + 8 <= n_; first += 8) visit(Lanes<8>(), first);
      for (; first < n_; ++first) visit(Lanes<1>(), first);
    }
  }

  template <int N, int Together, Products Use, bool Sparse>
  BUMPFOIL_ALWAYS_INLINE void products_of_part(const double* factors, Eigen::Index factors_stride, const double* rows,
                                               Eigen::Index count, double* targets) const {
    Sums<N, Together> sums;
    sums.template begin<Use>(targets, stride());
    for (Eigen::Index k = 0; k < count; ++k) {
      if constexpr (Sparse) {
        bool zero = true;
        for (int t = 0; t < Together; ++t) zero = zero && factors[t * factors_stride + k] == 0.0;
        if (zero) continue;
      }
      Row<N> row;
      row.load(rows + k * stride());
      sums.template use<Use>(factors + k, factors_stride, row);
    }
    sums.store(targets, stride());
  }

  /// Brings the largest number of column k, from the diagonal on, to the diagonal.
  /// @return false if it is zero or not finite
  [[nodiscard]] BUMPFOIL_ALWAYS_INLINE bool exchange_rows(double* a, Eigen::Index k, int* pivots) const {
    const Eigen::Index s = stride();
    Eigen::Index best = k;
    for (Eigen::Index r = k + 1; r < size(); ++r) {
      if (std::abs(a[r * s + k]) > std::abs(a[best * s + k])) best = r;
    }
    pivots[k] = static_cast<int>(best);
    if (best != k) std::swap_ranges(a + k * s, a + (k + 1) * s, a + best * s);
    return a[k * s + k] != 0.0 && std::isfinite(a[k * s + k]);
  }

  Eigen::Index n_;
};

/// row += sign * sum over k of factors[k * step] * (row k of `rows`), with the widest vectors of this processor.
/// Factors that are zero, as most couplings are, cost nothing. For panels: many right-hand sides side by side.
/// @param count    of factors, and of rows
/// @param columns  numbers in a row
void add_rows(double sign, const double* factors, Eigen::Index step, Eigen::Index count, const double* rows,
              Eigen::Index columns, double* row);

}  // namespace bumpfoil
