#include "bumpfoil/film/film_mesh.hpp"

#include <numbers>
#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

namespace {

Vector weights_of(const Vector& intervals, bool closed) {
  const Eigen::Index n = intervals.size();
  Vector weights = Vector::Zero(closed ? n : n + 1);
  weights.head(n) = 0.5 * intervals;
  weights.tail(weights.size() - 1) += 0.5 * intervals.head(weights.size() - 1);
  if (closed) weights[0] += 0.5 * intervals[n - 1];
  return weights;
}

}  // namespace

Vector FilmMesh::angles() const {
  Vector places(nodes());
  double place = 0.0;
  for (int k = 0; k < nodes(); ++k) {
    places[k] = dtheta * place;
    if (k < columns) place += intervals[k];
  }
  return places;
}

Matrix FilmMesh::field(double value) const {
  return Matrix::Constant(rows + 1, nodes(), value);
}

FilmMesh make_closed_mesh(int columns, int rows, double half_width) {
  BUMPFOIL_ASSERT(columns >= 3 && rows >= 1);
  const Vector equal = Vector::Ones(columns);
  return {columns, rows, 2.0 * std::numbers::pi / columns, half_width / rows, true, equal, weights_of(equal, true)};
}

FilmMesh make_slotted_mesh(int columns, int rows, double half_width, double theta_end) {
  return make_slotted_mesh(Vector::Ones(columns), theta_end / columns, rows, half_width);
}

FilmMesh make_slotted_mesh(Vector intervals, double dtheta, int rows, double half_width) {
  const auto columns = static_cast<int>(intervals.size());
  BUMPFOIL_ASSERT(columns >= 2 && rows >= 1);
  Vector weights = weights_of(intervals, false);
  return {columns, rows, dtheta, half_width / rows, false, std::move(intervals), std::move(weights)};
}

}  // namespace bumpfoil
