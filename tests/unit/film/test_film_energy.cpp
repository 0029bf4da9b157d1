#include "bumpfoil/film/film_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bumpfoil {
namespace {

/// A smooth film that satisfies no equation.
/// @param edge  pressure at its edges; its excess over 1 is 1.5 times as high at the last one
/// @param t     time
FilmState some_film(const FilmMesh& mesh, double edge, double t = 0.0) {
  FilmState film{mesh.field(1.0), mesh.field(1.0)};
  const Vector theta = mesh.angles();
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j <= mesh.rows; ++j) {
      film.pressure(j, k) += (0.4 * std::sin(theta[k]) + 0.2 * t * std::cos(theta[k] + t)) * (1.0 - 0.1 * j);
      film.thickness(j, k) += 0.3 * std::cos(theta[k] - t) + 0.1 * t * t;
    }
  }
  film.pressure.row(mesh.rows).setConstant(edge);
  if (!mesh.closed) {
    film.pressure.col(0).setConstant(edge);
    film.pressure.col(mesh.columns).setConstant(1.5 * edge - 0.5);
  }
  return film;
}

/// For any fields, the power supplied by surfaces and edges equals the dissipation of the flow and the storage of
/// unsteady volumes.
TEST(FilmPowers, AreResidualsTimesTheLogarithmOfThePressure) {
  for (const double edge : {1.0, 1.3}) {
    for (const FilmMesh& mesh : {make_slotted_mesh(12, 4, 0.5, 2.0), make_closed_mesh(12, 4, 0.5)}) {
      const FilmState film = some_film(mesh, edge);
      const ReynoldsEquation equation{.mesh = mesh, .bearing_number = -3.0, .knudsen = 0.02};
      Matrix residual;
      reynolds_residual(equation, film, residual);
      const int first = mesh.first_unknown();
      const Matrix inside = residual.block(0, first, mesh.rows, mesh.unknown_columns());
      const Matrix logs = film.pressure.array().log().matrix().block(0, first, mesh.rows, mesh.unknown_columns());
      const double stored = -2.0 * inside.cwiseProduct(logs).sum();
      const FilmPowers powers = film_powers(equation, film);
      EXPECT_GT(std::abs(stored), 0.1);
      EXPECT_GT(powers.dissipated, 0.1);
      EXPECT_NEAR(powers.entrained + powers.supplied, powers.dissipated + stored, 1e-13 * powers.dissipated);
      EXPECT_EQ(powers.supplied != 0.0, edge != 1.0);
    }
  }
}

/// dE = sum of areas (ln P d(P H) inside - (P - 1) dH).
TEST(FilmPowers, FreeEnergyIsStoredAndDoesWork) {
  const FilmMesh mesh = make_slotted_mesh(12, 4, 0.5, 2.0);
  const double dt = 1e-4;
  const FilmState before = some_film(mesh, 1.3, 0.5 - dt);
  const FilmState now = some_film(mesh, 1.3, 0.5);
  const FilmState after = some_film(mesh, 1.3, 0.5 + dt);
  double expected = 0.0;
  for (int k = 0; k <= mesh.columns; ++k) {
    for (int j = 0; j <= mesh.rows; ++j) {
      const double area = 2.0 * mesh.dtheta * mesh.dzeta * mesh.row_weight(j) * mesh.column_weight(k);
      const double content = film_content(after)(j, k) - film_content(before)(j, k);
      const bool edge = k == 0 || k == mesh.columns || j == mesh.rows;
      if (!edge) expected += area * std::log(now.pressure(j, k)) * content;
      expected -= area * (now.pressure(j, k) - 1.0) * (after.thickness(j, k) - before.thickness(j, k));
    }
  }
  EXPECT_GT(std::abs(expected), 1e-6);
  EXPECT_NEAR(free_energy(mesh, after) - free_energy(mesh, before), expected, 1e-6 * std::abs(expected));
}

TEST(FilmPowers, GasAtAmbientPressureHoldsNothing) {
  const FilmMesh mesh = make_closed_mesh(8, 3, 0.5);
  EXPECT_EQ(free_energy(mesh, {mesh.field(1.0), mesh.field(0.7)}), 0.0);
}

}  // namespace
}  // namespace bumpfoil
