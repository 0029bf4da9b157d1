#include "bearing/krylov_space.hpp"

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

KrylovSpace::KrylovSpace(const Vector& start, Eigen::Index most)
    : basis_(start.size(), most + 1), H_(Matrix::Zero(most, most)) {
  basis_.col(0) = start / start.norm();
}

void KrylovSpace::add(Vector image) {
  BUMPFOIL_ASSERT(can_grow());
  const Eigen::Index m = ++size_;
  // Orthogonalised twice: the second pass removes the round-off of the first.
  for (int pass = 0; pass < 2; ++pass) {
    const Vector parts = basis_.leftCols(m).transpose() * image;
    image.noalias() -= basis_.leftCols(m) * parts;
    H_.col(m - 1).head(m) += parts;
  }
  next_ = image.norm();
  if (m == H_.cols() || !(next_ > 0.0)) return;
  H_(m, m - 1) = next_;
  basis_.col(m) = image / next_;
}

}  // namespace bumpfoil
