#pragma once

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// Orthonormal basis V of the Krylov space of a real operator C on one vector or several, one direction after the other
/// by Arnoldi's method [Saad2011]:
///
///     C V = V H + V_next H_next
///
/// Directions whose image is known, V, are followed by those whose image is to be added next, V_next: as many as there
/// were starts, but for those that the space held already. H has so many diagonals below its main one.
class KrylovSpace {
 public:
  /// @param starts  columns that span the first directions, not all zero
  /// @param most    directions that there may be
  KrylovSpace(const Matrix& starts, Eigen::Index most);

  /// Directions whose image is known: the columns of V, basis().
  [[nodiscard]] Eigen::Index size() const { return size_; }
  /// Whether the images of all next() can be added: not where the space holds all that C makes of it.
  [[nodiscard]] bool can_grow() const { return known_ > size_ && known_ <= H_.cols(); }
  /// V_next
  [[nodiscard]] auto next() const { return basis_.middleCols(size_, known_ - size_); }
  /// Adds the image of the first of next().
  void add(Vector image);

  [[nodiscard]] auto basis() const { return basis_.leftCols(size_); }
  /// H
  [[nodiscard]] auto hessenberg() const { return H_.topLeftCorner(size_, size_); }
  /// H_next
  [[nodiscard]] auto into_next() const { return H_.block(size_, 0, known_ - size_, size_); }
  /// Coordinates of the starts: a row for each direction that they brought, a column for each start.
  [[nodiscard]] const Matrix& start() const { return start_; }
  /// The same with a row for each direction of the basis, the first of which has all that starts hold.
  [[nodiscard]] Matrix start_of_all() const;

 private:
  /// Takes what the space holds out of a vector, and makes a direction of the rest unless that is round-off.
  /// @param parts  receives its coordinates, the rest included
  void orthogonalise(Vector& vector, Eigen::Ref<Vector> parts);

  Matrix basis_;  ///< V, V_next and room for more
  Matrix H_;
  Matrix start_;
  Eigen::Index size_{};
  Eigen::Index known_{};  ///< directions, V_next included
};

}  // namespace bumpfoil
