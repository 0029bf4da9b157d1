#include "bumpfoil/film/film_energy.hpp"

#include <cmath>

#include "film/faces.hpp"

namespace bumpfoil {
namespace {

/// Whether P is prescribed at a node.
bool is_at_edge(const FilmMesh& mesh, int j, int k) {
  return mesh.is_side(j) || (!mesh.closed && (k == 0 || k == mesh.columns));
}

}  // namespace

FilmPowers film_powers(const ReynoldsEquation& equation, const FilmState& film) {
  const FilmMesh& mesh = equation.mesh;
  const Matrix log_pressure = film.pressure.array().log().matrix();
  FilmPowers powers;
  /// @param outflow  of node (j, k)
  const auto supply = [&](int j, int k, double outflow) {
    if (is_at_edge(mesh, j, k)) powers.supplied += outflow * log_pressure(j, k);
  };
  for_each_column_face(equation, film, [&](int j, int a, int b, double width, const FaceFlux& flux) {
    const FilmNode from = node_of(film, j, a);
    const FilmNode to = node_of(film, j, b);
    const double rise = width * (log_pressure(j, b) - log_pressure(j, a));
    const double gradient = (to.pressure - from.pressure) / mesh.interval(a);
    const double drift = Conductance(from, to, equation.knudsen).value * gradient;
    powers.dissipated += rise * drift;
    powers.entrained += rise * (flux.value + drift);
    supply(j, a, width * flux.value);
    supply(j, b, -width * flux.value);
  });
  for_each_row_face(equation, film, [&](int j, int k, double width, const FaceFlux& flux) {
    powers.dissipated -= width * (log_pressure(j + 1, k) - log_pressure(j, k)) * flux.value;
    supply(j, k, width * flux.value);
    supply(j + 1, k, -width * flux.value);
  });
  for (double* part : {&powers.entrained, &powers.dissipated, &powers.supplied}) *part *= mesh.copies();
  return powers;
}

double free_energy(const FilmMesh& mesh, const FilmState& film) {
  double energy = 0.0;
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j <= mesh.rows; ++j) {
      const auto [P, H] = node_of(film, j, k);
      const double stored = is_at_edge(mesh, j, k) ? 0.0 : P * std::log(P);
      energy += mesh.row_weight(j) * mesh.column_weight(k) * H * (stored - (P - 1.0));
    }
  }
  return mesh.copies() * mesh.dtheta * mesh.dzeta * energy;
}

}  // namespace bumpfoil
