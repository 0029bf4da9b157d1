#include "bumpfoil/film/reynolds.hpp"

#include <cmath>

#include "bumpfoil/core/assert.hpp"
#include "film/faces.hpp"

namespace bumpfoil {
namespace {

/// Storage of the squeeze term, and its derivatives with respect to P and H.
template <typename Visitor>
void for_each_store(const ReynoldsEquation& equation, Visitor&& visit) {
  if (equation.squeeze_rate == 0.0) return;
  const FilmMesh& mesh = equation.mesh;
  const double rate = equation.squeeze_rate * mesh.dtheta * mesh.dzeta;
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j <= mesh.rows; ++j) visit(j, k, rate * mesh.column_weight(k) * mesh.row_weight(j));
  }
}

void set_zero(FilmStencil& stencil, const FilmMesh& mesh) {
  for (Matrix* part : {&stencil.own, &stencil.before, &stencil.after, &stencil.inside, &stencil.outside}) {
    part->setZero(mesh.rows + 1, mesh.nodes());
  }
}

}  // namespace

void reynolds_residual(const ReynoldsEquation& equation, const FilmState& film, Matrix& residual) {
  const FilmMesh& mesh = equation.mesh;
  residual.setZero(mesh.rows + 1, mesh.nodes());
  for_each_column_face(equation, film, [&](int j, int a, int b, double width, const FaceFlux& flux) {
    residual(j, a) += width * flux.value;
    residual(j, b) -= width * flux.value;
  });
  for_each_row_face(equation, film, [&](int j, int k, double width, const FaceFlux& flux) {
    residual(j, k) += width * flux.value;
    residual(j + 1, k) -= width * flux.value;
  });
  for_each_store(equation, [&](int j, int k, double rate) {
    residual(j, k) += rate * (film.pressure(j, k) * film.thickness(j, k) - equation.previous_content(j, k));
  });
}

void linearise_reynolds(const ReynoldsEquation& equation, const FilmState& film, Matrix& residual,
                        FilmJacobian& jacobian) {
  const FilmMesh& mesh = equation.mesh;
  FilmStencil& P = jacobian.by_pressure;
  FilmStencil& H = jacobian.by_thickness;
  set_zero(P, mesh);
  set_zero(H, mesh);
  residual.setZero(mesh.rows + 1, mesh.nodes());
  for_each_column_face(equation, film, [&](int j, int a, int b, double width, const FaceFlux& flux) {
    residual(j, a) += width * flux.value;
    residual(j, b) -= width * flux.value;
    P.own(j, a) += width * flux.by_pressure[0];
    P.after(j, a) = width * flux.by_pressure[1];
    P.before(j, b) = -width * flux.by_pressure[0];
    P.own(j, b) -= width * flux.by_pressure[1];
    H.own(j, a) += width * flux.by_thickness[0];
    H.after(j, a) = width * flux.by_thickness[1];
    H.before(j, b) = -width * flux.by_thickness[0];
    H.own(j, b) -= width * flux.by_thickness[1];
  });
  for_each_row_face(equation, film, [&](int j, int k, double width, const FaceFlux& flux) {
    residual(j, k) += width * flux.value;
    residual(j + 1, k) -= width * flux.value;
    P.own(j, k) += width * flux.by_pressure[0];
    P.outside(j, k) = width * flux.by_pressure[1];
    P.inside(j + 1, k) = -width * flux.by_pressure[0];
    P.own(j + 1, k) -= width * flux.by_pressure[1];
    H.own(j, k) += width * flux.by_thickness[0];
    H.outside(j, k) = width * flux.by_thickness[1];
    H.inside(j + 1, k) = -width * flux.by_thickness[0];
    H.own(j + 1, k) -= width * flux.by_thickness[1];
  });
  for_each_store(equation, [&](int j, int k, double rate) {
    residual(j, k) += rate * (film.pressure(j, k) * film.thickness(j, k) - equation.previous_content(j, k));
    P.own(j, k) += rate * film.thickness(j, k);
    H.own(j, k) += rate * film.pressure(j, k);
  });
}

Matrix stencil_product(const FilmMesh& mesh, const FilmStencil& stencil, const Matrix& change) {
  Matrix product = stencil.own.cwiseProduct(change);
  BUMPFOIL_ASSERT(change.cols() == mesh.nodes());
  for (int a = 0; a < mesh.columns; ++a) {
    const int b = mesh.next(a);
    product.col(a) += stencil.after.col(a).cwiseProduct(change.col(b));
    product.col(b) += stencil.before.col(b).cwiseProduct(change.col(a));
  }
  const Eigen::Index m = mesh.rows;
  product.topRows(m) += stencil.outside.topRows(m).cwiseProduct(change.bottomRows(m));
  product.bottomRows(m) += stencil.inside.bottomRows(m).cwiseProduct(change.topRows(m));
  return product;
}

Matrix film_content(const FilmState& film) {
  return film.pressure.cwiseProduct(film.thickness);
}

}  // namespace bumpfoil
