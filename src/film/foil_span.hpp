#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/core/dense_kernels.hpp"

namespace bumpfoil {

/// How the equations of a column depend on a neighbouring one: on each unknown by its own alone, and all on its last
/// ones, those of the foil,
///
///     diag(own) + sum_t by_foil_t e_t^T
///
/// with the entries of the foil's unknowns counted once, in `by_foil`.
struct ColumnCoupling {
  LineVector own;
  LineVector by_foil;  ///< one behind the other, each as long as `own`

  void resize(Eigen::Index length, Eigen::Index of_foil);  ///< to zeros
  /// How the equations depend on unknown t of the foil.
  [[nodiscard]] double* by(Eigen::Index t) { return by_foil.data() + t * static_cast<Eigen::Index>(own.size()); }
};

/// Columns of film and foil between two others, the neighbours: eliminated from their equations, in one sweep that
/// carries the coupling to the neighbour before along. Neighbours that stand side by side have none between them, and
/// couple each other as they are. With G = D^-1 of the column with those before it eliminated,
///
///     x_i = g_i - X_i x_{i+1} - Y_i x_before,     X_i = G U_i,     Y_i = -G L_i Y_{i-1}
///
/// G is formed, as couplings times G cost little then.
class FoilSpan {
 public:
  using Block = Eigen::Map<Matrix, 0, Eigen::OuterStride<>>;

  virtual ~FoilSpan() = default;

  [[nodiscard]] virtual int columns() const = 0;

  /// Coupling of column i to the one before it, itself, and the one after it; and of the neighbours to the first and
  /// the last column. To be filled before eliminate(); `own` is overwritten by it.
  virtual ColumnCoupling& to_before(int i) = 0;
  virtual Block own(int i) = 0;
  virtual ColumnCoupling& to_after(int i) = 0;
  virtual ColumnCoupling& of_before() = 0;
  virtual ColumnCoupling& of_after() = 0;

  /// Contribution of the span to the equations of its neighbours.
  struct Condensed {
    Matrix before, before_by_after, after_by_before, after;
  };
  /// Eliminates the columns.
  /// @return false if their equations are singular
  [[nodiscard]] virtual bool eliminate(Condensed& condensed) = 0;

  /// The same for right-hand sides, all in one pass through the factors, which take longer to read than to use.
  /// @param right   one behind the other, with a column for each of the span's
  /// @param before  what is added to those of the neighbour before, if there is one: a column for each
  /// @param after   of the one after
  virtual void condense(const Matrix& right, Eigen::Ref<Matrix> before, Eigen::Ref<Matrix> after) = 0;

  /// The unknowns of the columns for the right-hand sides that were condensed last, in their order.
  /// @param before, after  unknowns of the neighbours
  virtual void expand(const Matrix& before, const Matrix& after, Matrix& solution) = 0;
};

/// Some block sizes, those of usual meshes, are faster than others.
/// @param columns       1 or more; none between two neighbours side by side
/// @param of_foil       how many of the unknowns of a column are the foil's: the last ones
/// @param has_before    false: the first column has none before it
/// @param instructions  that this processor has
std::unique_ptr<FoilSpan> make_foil_span(int columns, int block_size, int of_foil, bool has_before,
                                         VectorInstructions instructions = widest_vector_instructions());

}  // namespace bumpfoil
