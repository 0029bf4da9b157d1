#include "bearing/krylov_space.hpp"

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// Rest of a vector, as part of it, that is round-off: of an operation for each of its some thousand components.
constexpr double no_rest = 1e-13;

}  // namespace

KrylovSpace::KrylovSpace(const Matrix& starts, Eigen::Index most)
    : basis_(starts.rows(), most + starts.cols()), H_(Matrix::Zero(most + starts.cols(), most)) {
  start_.setZero(starts.cols(), starts.cols());
  for (Eigen::Index i = 0; i < starts.cols(); ++i) {
    Vector vector = starts.col(i);
    orthogonalise(vector, start_.col(i));
  }
  start_.conservativeResize(known_, Eigen::NoChange);
}

Matrix KrylovSpace::start_of_all() const {
  BUMPFOIL_ASSERT(size_ >= start_.rows());
  Matrix all = Matrix::Zero(size_, start_.cols());
  all.topRows(start_.rows()) = start_;
  return all;
}

void KrylovSpace::add(Vector image) {
  BUMPFOIL_ASSERT(known_ > size_ && size_ < H_.cols());
  orthogonalise(image, H_.col(size_));
  ++size_;
}

void KrylovSpace::orthogonalise(Vector& vector, Eigen::Ref<Vector> parts) {
  const double whole = vector.norm();
  // Twice: once leaves what roundings of the first time make.
  for (int pass = 0; pass < 2; ++pass) {
    const Vector found = basis_.leftCols(known_).transpose() * vector;
    vector.noalias() -= basis_.leftCols(known_) * found;
    parts.head(known_) += found;
  }
  const double rest = vector.norm();
  if (!(rest > no_rest * whole)) return;
  parts[known_] = rest;
  basis_.col(known_++) = vector / rest;
}

}  // namespace bumpfoil
