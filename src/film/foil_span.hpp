#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/core/dense_kernels.hpp"

namespace bumpfoil {

/// Derivatives of the equations of a column by a neighbouring column: each row depends on its own unknown, and all rows
/// on the last ones, those of the foil,
/// |     diag(own) + sum_t by_foil_t e_t^T
/// | Entries of the foil's unknowns are stored once, in `by_foil`.
struct ColumnCoupling {
  LineVector own;
  LineVector by_foil;  ///< one after the other, each of the length of `own`

  void resize(Eigen::Index length, Eigen::Index of_foil);  ///< to zeros
  /// Derivatives by foil unknown t.
  [[nodiscard]] double* by(Eigen::Index t) { return by_foil.data() + t * static_cast<Eigen::Index>(own.size()); }
};

/// Columns of film and foil between two others, the neighbours. One sweep eliminates them from the equations of the
/// neighbours and carries the coupling to the preceding neighbour along. Adjacent neighbours have no columns between
/// them and are coupled directly. With G = D^-1 of the column after elimination of those before it,
/// |     x_i = g_i - X_i x_{i+1} - Y_i x_before,     X_i = G U_i,     Y_i = -G L_i Y_{i-1}
/// | G is formed explicitly, as couplings times G are cheap then.
class FoilSpan {
 public:
  using Block = Eigen::Map<Matrix, 0, Eigen::OuterStride<>>;

  virtual ~FoilSpan() = default;

  [[nodiscard]] virtual int columns() const = 0;

  /// Couplings of column i to the previous column, itself and the next one; and of the neighbours to the first and the
  /// last column. To be filled before eliminate(), which overwrites `own`.
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

  /// The same for right-hand sides, all in one pass through the factors, which take longer to read than to apply.
  /// @param right   of all columns in sequence, one matrix column per right-hand side
  /// @param before  receives the contribution to the preceding neighbour, if there is one, one column each
  /// @param after   the same for the next neighbour
  virtual void condense(const Matrix& right, Eigen::Ref<Matrix> before, Eigen::Ref<Matrix> after) = 0;

  /// The unknowns of all columns for the right-hand sides condensed last, in sequence.
  /// @param before, after  unknowns of the neighbours
  virtual void expand(const Matrix& before, const Matrix& after, Matrix& solution) = 0;
};

/// Creates a span; block sizes of usual meshes have faster code.
/// @param columns       1 or more; 0 between adjacent neighbours
/// @param of_foil       number of foil unknowns per column: the last ones
/// @param has_before    false: the first column has no predecessor
/// @param instructions  available on this processor
std::unique_ptr<FoilSpan> make_foil_span(int columns, int block_size, int of_foil, bool has_before,
                                         VectorInstructions instructions = widest_vector_instructions());

}  // namespace bumpfoil
