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

/// One interval suffices on half the width, where row 0 is inside the film.
double row_length(int rows, double half_width, WidthPart width) {
  BUMPFOIL_ASSERT(rows >= (width == WidthPart::half ? 1 : 2));
  return (width == WidthPart::half ? 1.0 : 2.0) * half_width / rows;
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

FilmMesh make_closed_mesh(int columns, int rows, double half_width, WidthPart width) {
  BUMPFOIL_ASSERT(columns >= 3);
  const Vector equal = Vector::Ones(columns);
  return {.columns = columns,
          .rows = rows,
          .dtheta = 2.0 * std::numbers::pi / columns,
          .dzeta = row_length(rows, half_width, width),
          .closed = true,
          .width = width,
          .intervals = equal,
          .weights = weights_of(equal, true)};
}

FilmMesh make_slotted_mesh(int columns, int rows, double half_width, double theta_end, WidthPart width) {
  return make_slotted_mesh(Vector::Ones(columns), theta_end / columns, rows, half_width, width);
}

FilmMesh make_slotted_mesh(Vector intervals, double dtheta, int rows, double half_width, WidthPart width) {
  const auto columns = static_cast<int>(intervals.size());
  BUMPFOIL_ASSERT(columns >= 2);
  Vector weights = weights_of(intervals, false);
  return {.columns = columns,
          .rows = rows,
          .dtheta = dtheta,
          .dzeta = row_length(rows, half_width, width),
          .closed = false,
          .width = width,
          .intervals = std::move(intervals),
          .weights = std::move(weights)};
}

}  // namespace bumpfoil
