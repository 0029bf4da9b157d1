#pragma once

#include <memory>

#include "bumpfoil/core/block_tridiagonal_lu.hpp"
#include "bumpfoil/film/film_solver.hpp"
#include "film/column_chain.hpp"

namespace bumpfoil {

/// The linear system of Newton's method for the pressures of a film: block tridiagonal by columns. In a closed film
/// column 0 borders it: the chain of all other columns has it as both its neighbours.
class PressureSystem {
 public:
  explicit PressureSystem(const FilmMesh& mesh);

  /// Sets the derivatives of the equations by the unknown pressures.
  void assemble(const FilmJacobian& jacobian, const Foundation& foundation);
  [[nodiscard]] bool factor();
  /// Solves for the step that cancels `residual`; writes it to the unknown pressures of `step`.
  void solve(const Matrix& residual, Matrix& step);

 private:
  void read_border_step(const Matrix& residual);

  FilmMesh mesh_;
  std::unique_ptr<ColumnChain> chain_;
  // Couplings of column 0 of a closed film to the previous column, itself and the next one.
  RowMajorMatrix border_before_, border_own_, border_after_;
  ColumnChain::Response to_before_, to_after_;
  BlockTridiagonalLU<Eigen::Dynamic> border_;  ///< one block: the Schur complement of column 0
  Vector right_, border_step_;
};

}  // namespace bumpfoil
