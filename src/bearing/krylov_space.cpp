#include "bearing/krylov_space.hpp"

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// Part of a direction that is left by those before it. Their products with it are then ten roundings.
constexpr double little_left = 0.1;

}  // namespace

KrylovSpace::KrylovSpace(const Vector& start, Eigen::Index most)
    : basis_(start.size(), most + 1), H_(Matrix::Zero(most, most)) {
  basis_.col(0) = start / start.norm();
}

void KrylovSpace::add(Vector image) {
  BUMPFOIL_ASSERT(can_grow());
  const Eigen::Index m = ++size_;
  // Again where so little is left that the roundings of the last time count.
  next_ = image.norm();
  double before{};
  do {
    before = next_;
    const Vector parts = basis_.leftCols(m).transpose() * image;
    image.noalias() -= basis_.leftCols(m) * parts;
    H_.col(m - 1).head(m) += parts;
    next_ = image.norm();
  } while (next_ < little_left * before);
  if (m == H_.cols() || !(next_ > 0.0)) return;
  H_(m, m - 1) = next_;
  basis_.col(m) = image / next_;
}

}  // namespace bumpfoil
