#include "bumpfoil/film/film_integrals.hpp"

#include <cmath>

#include "film/faces.hpp"

namespace bumpfoil {
namespace {

/// H^3 + 6 Kn H^2 / P at a face.
double dissipating_conductance(const FilmNode& a, const FilmNode& b, double knudsen) {
  return Conductance(a, b, knudsen).value / (0.5 * (a.pressure + b.pressure));
}

}  // namespace

FilmIntegrals film_integrals(const ReynoldsEquation& equation, const FilmState& film) {
  const FilmMesh& mesh = equation.mesh;
  const double Kn = equation.knudsen;
  const Vector theta = mesh.angles();
  FilmIntegrals sum;
  for (int k = 0; k < mesh.nodes(); ++k) {
    double excess = 0.0;
    for (int j = 0; j <= mesh.rows; ++j) {
      const FilmNode node = node_of(film, j, k);
      const double area = mesh.row_weight(j) * mesh.column_weight(k) * mesh.dzeta * mesh.dtheta;
      excess += area * (node.pressure - 1.0);
      sum.couette += area / (node.thickness + 2.0 * Kn / node.pressure);
      if (j == mesh.rows) continue;
      const FilmNode next = node_of(film, j + 1, k);
      const double rise = next.pressure - node.pressure;
      sum.dissipation +=
          mesh.column_weight(k) * mesh.dtheta * rise * rise / mesh.dzeta * dissipating_conductance(node, next, Kn);
    }
    sum.cosine += excess * std::cos(theta[k]);
    sum.sine += excess * std::sin(theta[k]);
  }
  for (int a = 0; a < mesh.columns; ++a) {
    const int b = mesh.next(a);
    for (int j = 0; j <= mesh.rows; ++j) {
      const FilmNode node = node_of(film, j, a);
      const FilmNode next = node_of(film, j, b);
      const double width = mesh.row_weight(j) * mesh.dzeta;
      const double rise = next.pressure - node.pressure;
      sum.poiseuille += width * 0.5 * (node.thickness + next.thickness) * rise;
      sum.dissipation += width * rise * rise / mesh.interval(a) * dissipating_conductance(node, next, Kn);
    }
  }
  for (double* part : {&sum.cosine, &sum.sine, &sum.couette, &sum.poiseuille, &sum.dissipation}) *part *= mesh.copies();
  return sum;
}

FilmFlows film_flows(const FilmMesh& mesh, const Matrix& residual) {
  FilmFlows flows;
  const auto inside = Eigen::seqN(mesh.first_unknown(), mesh.unknown_columns());
  const auto out_of = [&](int row) { return -residual(row, inside).sum(); };
  flows.right_side = out_of(mesh.rows);
  flows.sides = mesh.width == WidthPart::half ? 2.0 * flows.right_side : flows.right_side + out_of(0);
  if (mesh.closed) return flows;
  flows.start = mesh.copies() * residual.col(0).sum();
  flows.end = -mesh.copies() * residual.col(mesh.columns).sum();
  return flows;
}

ThinnestPlace thinnest_place(const FilmMesh& mesh, const Matrix& thickness) {
  Eigen::Index row = 0;
  Eigen::Index column = 0;
  ThinnestPlace place;
  place.thickness = thickness.minCoeff(&row, &column);
  place.column = static_cast<int>(column);
  place.row = static_cast<int>(row);
  place.vertex_thickness = place.thickness;
  const double theta = mesh.angles()[column];
  place.theta = place.vertex_theta = theta;
  const Eigen::Index n = mesh.nodes();
  if (!mesh.closed && (column == 0 || column == n - 1)) return place;
  const double before = thickness(row, (column + n - 1) % n);
  const double after = thickness(row, (column + 1) % n);
  // The parabola through the three nodes; a and b are the intervals before and after.
  const double a = mesh.intervals[(column + n - 1) % n];
  const double b = mesh.intervals[column];
  const double scale = 1.0 / (a * b * (a + b));
  const double curvature = 2.0 * scale * (b * before - (a + b) * place.thickness + a * after);
  if (curvature <= 0.0) return place;
  const double slope = scale * (a * a * after - b * b * before - (a * a - b * b) * place.thickness);
  place.vertex_thickness -= 0.5 * slope * slope / curvature;
  place.vertex_theta -= mesh.dtheta * slope / curvature;
  return place;
}

}  // namespace bumpfoil
