#include "film/foil_span.hpp"

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// Fixed sizes are for wide vectors, where there are any to choose from: without them the generic size will do.
#ifdef BUMPFOIL_WIDE_VECTORS
constexpr VectorInstructions least_of_fixed_sizes = VectorInstructions::avx2;
#else
constexpr VectorInstructions least_of_fixed_sizes = VectorInstructions::baseline;
#endif

/// @tparam T  number of foil unknowns among the B of a column; both or neither may be Eigen::Dynamic
template <int B, int T>
class FoilSpanOf final : public FoilSpan {
 public:
  FoilSpanOf(int columns, int block_size, int of_foil, bool has_before, VectorInstructions instructions)
      : n_(block_size),
        of_foil_(of_foil),
        stride_(row_stride<B>(block_size)),
        has_before_(has_before),
        instructions_(instructions),
        columns_(static_cast<std::size_t>(columns)),
        pivots_(static_cast<std::size_t>(block_size)) {
    BUMPFOIL_ASSERT(instructions >= least);
    for (Column& column : columns_) {
      column.to_before.resize(stride_, of_foil);
      column.to_after.resize(stride_, of_foil);
      for (LineVector* block : {&column.G, &column.X, &column.Y, &column.W}) {
        block->resize(static_cast<std::size_t>(block_size * stride_));
      }
    }
    of_before_.resize(stride_, of_foil);
    of_after_.resize(stride_, of_foil);
    for (LineVector* block : {&carried_, &added_}) block->resize(static_cast<std::size_t>(block_size * stride_));
    scratch_.resize(static_cast<std::size_t>(stride_));
  }

  [[nodiscard]] int columns() const override { return static_cast<int>(columns_.size()); }
  ColumnCoupling& to_before(int i) override { return columns_[static_cast<std::size_t>(i)].to_before; }
  Block own(int i) override { return map(columns_[static_cast<std::size_t>(i)].G); }
  ColumnCoupling& to_after(int i) override { return columns_[static_cast<std::size_t>(i)].to_after; }
  ColumnCoupling& of_before() override { return of_before_; }
  ColumnCoupling& of_after() override { return of_after_; }

  bool eliminate(Condensed& condensed) override {
    const bool regular = with_vectors<least>(instructions_, [&](auto lanes) BUMPFOIL_ALWAYS_INLINE {
      return eliminate_with(DenseKernels<B, decltype(lanes)::value>(n_), condensed);
    });
    return regular;
  }

  void condense(const Matrix& right, Eigen::Ref<Matrix> before, Eigen::Ref<Matrix> after) override {
    set_sides(after.cols());
    with_vectors<least>(instructions_, [&](auto lanes) BUMPFOIL_ALWAYS_INLINE {
      const DenseKernels<B, decltype(lanes)::value> kernels(n_);
      fill(left_);
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        Column& column = columns_[i];
        for (Eigen::Index s = 0; s < sides_; ++s) {
          double* own = right_.data() + s * stride_;
          std::copy_n(right.data() + (s * columns() + static_cast<Eigen::Index>(i)) * n_, n_, own);
          if (i > 0) couple(kernels, column.to_before, columns_[i - 1].g.data() + s * stride_, own);
        }
        kernels.template products<Products::assign>(right_.data(), stride_, column.G.data(), n_, column.g.data(),
                                                    sides_);
        if (has_before_) kernels.products(right_.data(), stride_, column.W.data(), n_, left_.data(), sides_);
      }
      if (columns_.empty()) {
        fill(right_);
        return;
      }
      for (Eigen::Index s = 0; s < sides_; ++s) {
        couple<Products::negate>(kernels, of_after_, columns_.back().g.data() + s * stride_,
                                 right_.data() + s * stride_);
      }
    });
    for (Eigen::Index s = 0; s < sides_; ++s) {
      std::copy_n(left_.data() + s * stride_, n_, before.col(s).data());
      std::copy_n(right_.data() + s * stride_, n_, after.col(s).data());
    }
  }

  void expand(const Matrix& before, const Matrix& after, Matrix& solution) override {
    for (Eigen::Index s = 0; s < sides_; ++s) {
      std::copy_n(before.col(s).data(), n_, left_.data() + s * stride_);
      std::copy_n(after.col(s).data(), n_, right_.data() + s * stride_);
    }
    with_vectors<least>(instructions_, [&](auto lanes) BUMPFOIL_ALWAYS_INLINE {
      const DenseKernels<B, decltype(lanes)::value> kernels(n_);
      const double* next = right_.data();
      for (std::size_t i = columns_.size(); i-- > 0;) {
        Column& column = columns_[i];
        std::copy(column.g.begin(), column.g.end(), column.x.begin());
        kernels.products(next, stride_, column.X.data(), n_, column.x.data(), sides_);
        if (has_before_) kernels.products(left_.data(), stride_, column.Y.data(), n_, column.x.data(), sides_);
        next = column.x.data();
      }
    });
    solution.resize(n_, sides_ * columns());
    for (Eigen::Index s = 0; s < sides_; ++s) {
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        std::copy_n(columns_[i].x.data() + s * stride_, n_,
                    solution.col(s * columns() + static_cast<Eigen::Index>(i)).data());
      }
    }
  }

 private:
  static constexpr VectorInstructions least = B == Eigen::Dynamic ? VectorInstructions::baseline : least_of_fixed_sizes;

  /// Blocks are stored by columns with leading dimension stride_.
  struct Column {
    ColumnCoupling to_before, to_after;
    LineVector G;  ///< D, then its inverse
    LineVector X, Y;
    LineVector W;     ///< coupling of the preceding neighbour to this column, times G
    LineVector g, x;  ///< for all right-hand sides
  };

  void set_sides(Eigen::Index count) {
    if (count == sides_) return;
    sides_ = count;
    const auto size = static_cast<std::size_t>(count * stride_);
    for (Column& column : columns_) {
      for (LineVector* rows : {&column.g, &column.x}) rows->assign(size, 0.0);
    }
    for (LineVector* rows : {&left_, &right_}) rows->assign(size, 0.0);
  }

  [[nodiscard]] BUMPFOIL_ALWAYS_INLINE Eigen::Index of_foil() const { return T == Eigen::Dynamic ? of_foil_ : T; }
  Block map(LineVector& block) { return {block.data(), n_, n_, Eigen::OuterStride<>(stride_)}; }
  static void fill(LineVector& numbers) { std::fill(numbers.begin(), numbers.end(), 0.0); }
  [[nodiscard]] Matrix dense(const ColumnCoupling& S) const {
    const Eigen::Map<const Vector> own(S.own.data(), n_);
    const Eigen::Map<const Matrix, 0, Eigen::OuterStride<>> by_foil(S.by_foil.data(), n_, of_foil(),
                                                                    Eigen::OuterStride<>(stride_));
    Matrix all = own.asDiagonal();
    all.rightCols(of_foil()) += by_foil;
    return all;
  }

  /// y -= S x, or another use of the product
  template <Products Use = Products::subtract, typename Kernels>
  BUMPFOIL_ALWAYS_INLINE void couple(const Kernels& kernels, const ColumnCoupling& S, const double* x,
                                     double* y) const {
    kernels.template products_of_row<Use, T>(S.own.data(), x, x + n_ - of_foil(), S.by_foil.data(), of_foil(), y);
  }

  /// result -= S A
  template <Products Use = Products::subtract, typename Kernels>
  BUMPFOIL_ALWAYS_INLINE void couple_left(const Kernels& kernels, const ColumnCoupling& S, const LineVector& A,
                                          LineVector& result) const {
    for (Eigen::Index c = 0; c < n_; ++c) {
      couple<Use>(kernels, S, A.data() + c * stride_, result.data() + c * stride_);
    }
  }

  /// result -= A S
  template <Products Use = Products::subtract, typename Kernels>
  BUMPFOIL_ALWAYS_INLINE void couple_right(const Kernels& kernels, const LineVector& A, const ColumnCoupling& S,
                                           LineVector& result) const {
    double* to = result.data();
    for (Eigen::Index c = 0; c < n_ - of_foil(); ++c, to += stride_) {
      kernels.template products<Use>(S.own.data() + c, 0, A.data() + c * stride_, 1, to, 1);
    }
    for (Eigen::Index t = 0; t < of_foil(); ++t, to += stride_) {
      kernels.template products<Use>(S.by_foil.data() + t * stride_, 0, A.data(), n_, to, 1);
    }
  }

  /// result -= A C
  template <Products Use = Products::subtract, typename Kernels>
  BUMPFOIL_ALWAYS_INLINE void multiply(const Kernels& kernels, const LineVector& A, const LineVector& C,
                                       LineVector& result) const {
    kernels.template products<Use>(C.data(), stride_, A.data(), n_, result.data(), n_);
  }

  template <typename Kernels>
  BUMPFOIL_ALWAYS_INLINE bool eliminate_with(const Kernels& kernels, Condensed& condensed) {
    fill(added_);
    if (columns_.empty()) {
      condensed = {.before = map(added_),
                   .before_by_after = dense(of_before_),
                   .after_by_before = dense(of_after_),
                   .after = map(added_)};
      return true;
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      Column& column = columns_[i];
      if (i > 0) couple_left(kernels, column.to_before, columns_[i - 1].X, column.G);
      if (!kernels.invert(column.G.data(), scratch_.data(), pivots_.data())) return false;
      couple_right<Products::assign>(kernels, column.G, column.to_after, column.X);
      if (!has_before_) continue;
      if (i == 0) {
        couple_left<Products::assign>(kernels, of_before_, column.G, column.W);
        couple_right<Products::assign>(kernels, column.G, column.to_before, column.Y);
        couple_right(kernels, column.W, column.to_before, added_);
        continue;
      }
      // The neighbour couples to this column by -W U of the previous one, and this column to the neighbour by -L Y.
      const Column& last = columns_[i - 1];
      couple_right<Products::negate>(kernels, last.W, last.to_after, carried_);
      multiply<Products::assign>(kernels, carried_, column.G, column.W);
      couple_left<Products::negate>(kernels, column.to_before, last.Y, carried_);
      multiply<Products::assign>(kernels, column.G, carried_, column.Y);
      multiply(kernels, column.W, carried_, added_);
    }
    const Column& last = columns_.back();
    condensed.before = map(added_);
    if (has_before_) couple_right<Products::negate>(kernels, last.W, last.to_after, added_);
    condensed.before_by_after = map(added_);
    if (has_before_) couple_left<Products::negate>(kernels, of_after_, last.Y, added_);
    condensed.after_by_before = map(added_);
    couple_left<Products::negate>(kernels, of_after_, last.X, added_);
    condensed.after = map(added_);
    return true;
  }

  Eigen::Index n_, of_foil_, stride_;
  bool has_before_;
  VectorInstructions instructions_;
  std::vector<Column> columns_;
  ColumnCoupling of_before_, of_after_;
  LineVector carried_;    ///< coupling of this column and the preceding neighbour
  LineVector added_;      ///< contribution to the equations of a neighbour
  Eigen::Index sides_{};  ///< number of right-hand sides
  LineVector left_, right_, scratch_;
  std::vector<int> pivots_;
};

}  // namespace

void ColumnCoupling::resize(Eigen::Index length, Eigen::Index of_foil) {
  own.assign(static_cast<std::size_t>(length), 0.0);
  by_foil.assign(static_cast<std::size_t>(length * of_foil), 0.0);
}

std::unique_ptr<FoilSpan> make_foil_span(int columns, int block_size, int of_foil, bool has_before,
                                         VectorInstructions instructions) {
  BUMPFOIL_ASSERT(columns >= (has_before ? 0 : 1) && block_size >= of_foil);
  const auto make = [&]<int B, int T>() -> std::unique_ptr<FoilSpan> {
    return std::make_unique<FoilSpanOf<B, T>>(columns, block_size, of_foil, has_before, instructions);
  };
  if (instructions < least_of_fixed_sizes) return make.operator()<Eigen::Dynamic, Eigen::Dynamic>();
  // Specialised sizes: eight or sixteen pressures with U and M of a foil uniform over the width, or of one with a
  // parabola; 31 on the whole width, with a slope and a parabola.
  const int pressures = block_size - of_foil;
  if (of_foil == 2 && pressures == 8) return make.operator()<10, 2>();
  if (of_foil == 2 && pressures == 16) return make.operator()<18, 2>();
  if (of_foil == 6 && pressures == 8) return make.operator()<14, 6>();
  if (of_foil == 6 && pressures == 16) return make.operator()<22, 6>();
  if (of_foil == 8 && pressures == 31) return make.operator()<39, 8>();
  return make.operator()<Eigen::Dynamic, Eigen::Dynamic>();
}

}  // namespace bumpfoil
