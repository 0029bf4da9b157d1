#pragma once

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Orthonormal basis V of the Krylov space of a real operator C, one direction after the other by Arnoldi's method
/// [Saad2011]:
///
///     C V = V H + next v_next e_last^T
class KrylovSpace {
 public:
  /// @param start  first direction, nonzero
  /// @param most   maximum number of directions
  KrylovSpace(const Vector& start, Eigen::Index most);

  /// Directions whose image is known: the columns of V, basis().
  [[nodiscard]] Eigen::Index size() const { return size_; }
  /// Whether a direction can be added: false once the space is invariant under C.
  [[nodiscard]] bool can_grow() const { return size_ == 0 || (size_ < H_.cols() && next_ > 0.0); }
  /// The direction whose image add() expects.
  [[nodiscard]] auto direction() const { return basis_.col(size_); }
  /// Adds the image of direction().
  void add(Vector image);

  [[nodiscard]] auto basis() const { return basis_.leftCols(size_); }
  [[nodiscard]] auto hessenberg() const { return H_.topLeftCorner(size_, size_); }
  [[nodiscard]] double next() const { return next_; }

 private:
  Matrix basis_;
  Matrix H_;
  Eigen::Index size_{};
  double next_{};
};

}  // namespace bumpfoil
