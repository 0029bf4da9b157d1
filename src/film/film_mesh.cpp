#include "bumpfoil/film/film_mesh.hpp"

#include <numbers>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

Vector FilmMesh::angles() const {
  return dtheta * Vector::LinSpaced(nodes(), 0.0, static_cast<double>(nodes() - 1));
}

Matrix FilmMesh::field(double value) const {
  return Matrix::Constant(rows + 1, nodes(), value);
}

FilmMesh make_closed_mesh(int columns, int rows, double half_width) {
  BUMPFOIL_ASSERT(columns >= 3 && rows >= 1);
  return {columns, rows, 2.0 * std::numbers::pi / columns, half_width / rows, true};
}

FilmMesh make_slotted_mesh(int columns, int rows, double half_width, double theta_end) {
  BUMPFOIL_ASSERT(columns >= 2 && rows >= 1);
  return {columns, rows, theta_end / columns, half_width / rows, false};
}

}  // namespace bumpfoil
