#pragma once

#include <memory>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Equations of a run of neighbouring columns: block tridiagonal, not symmetric, one block per column. The run may have
/// a neighbour at either end whose unknowns are determined elsewhere: lower(0) couples the first column to the one
/// before it, upper(size - 1) the last to the one after it. Both neighbours may be the same column, which closes a
/// ring.
class ColumnChain {
 public:
  using Block = Eigen::Map<RowMajorMatrix>;

  virtual ~ColumnChain() = default;

  [[nodiscard]] virtual int columns() const = 0;
  [[nodiscard]] virtual int block_size() const = 0;

  /// Coupling of column i to the one before it, itself, and the one after it. To be filled before factor().
  virtual Block lower(int i) = 0;
  virtual Block diagonal(int i) = 0;
  virtual Block upper(int i) = 0;

  /// Factorises the equations with the neighbours held.
  /// @return false if they are singular; then no solve may follow
  [[nodiscard]] virtual bool factor() = 0;

  /// Overwrites the right-hand side by the solution with both neighbours held at zero; their couplings are not read.
  virtual void solve_in_place(Vector& x) const = 0;

  /// Negative change of the first and last columns per unit of a neighbour's unknown.
  struct Response {
    RowMajorMatrix first, last;
  };
  /// Responses to the previous and the next neighbour: A^-1 times lower(0), and times upper(columns() - 1).
  virtual void respond(Response& to_before, Response& to_after) = 0;
};

/// A chain with zero couplings. Block sizes of usual meshes have faster code.
std::unique_ptr<ColumnChain> make_column_chain(int columns, int block_size);

}  // namespace bumpfoil
