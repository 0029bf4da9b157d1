#include "bumpfoil/film/film_integrals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/film_cases.hpp"

namespace bumpfoil {
namespace {

TEST(FilmIntegrals, OfAPressureWaveAreThoseOfTheContinuum) {
  // The trapezoidal rule integrates trigonometric functions over the circle exactly.
  const FilmMesh mesh = make_closed_mesh(24, 4, 0.6);
  FilmState film{mesh.field(1.0), mesh.field(1.0)};
  film.pressure.rowwise() +=
      (0.3 * mesh.angles().array().cos() - 0.2 * mesh.angles().array().sin()).matrix().transpose();
  const FilmIntegrals sums = film_integrals({.mesh = mesh}, film);
  const double width = 1.2;
  EXPECT_NEAR(sums.cosine, 0.3 * std::numbers::pi * width, 1e-14);
  EXPECT_NEAR(sums.sine, -0.2 * std::numbers::pi * width, 1e-14);
  EXPECT_NEAR(sums.couette, 2.0 * std::numbers::pi * width, 1e-13);
  EXPECT_NEAR(sums.poiseuille, 0.0, 1e-14);
}

TEST(FilmIntegrals, ShearAndDissipationOfALinearPressure) {
  const FilmMesh mesh = make_slotted_mesh(8, 4, 0.5, 2.0);
  FilmState film{mesh.field(1.0), mesh.field(0.5)};
  film.pressure.rowwise() += (0.1 * mesh.angles()).transpose();
  for (int j = 0; j <= 4; ++j) film.pressure.row(j).array() += 0.3 * j * mesh.dzeta;
  const FilmIntegrals sums = film_integrals({.mesh = mesh, .bearing_number = 2.0}, film);
  EXPECT_NEAR(sums.couette, 2.0 * 2.0 / 1.0 * 1.0, 1e-13);                      // area 2, 1 / H = 2
  EXPECT_NEAR(sums.poiseuille, 0.5 * 0.1 * 2.0, 1e-14);                         // H dP/dtheta times the area
  EXPECT_NEAR(sums.dissipation, 0.125 * (0.1 * 0.1 + 0.3 * 0.3) * 2.0, 1e-14);  // H^3 |grad P|^2 times the area
  EXPECT_NEAR(sums.torque(2.0), sums.couette + 1.5 * sums.poiseuille, 1e-14);
}

TEST(FilmIntegrals, SlipLowersTheShear) {
  const FilmMesh mesh = make_slotted_mesh(8, 4, 0.5, 2.0);
  const FilmState film{mesh.field(2.0), mesh.field(0.5)};
  EXPECT_NEAR(film_integrals({.mesh = mesh, .knudsen = 0.1}, film).couette, 2.0 / (0.5 + 0.2 / 2.0), 1e-13);
}

TEST(FilmFlows, OfACouetteFlowPassFromEndToEnd) {
  const FilmMesh mesh = make_slotted_mesh(8, 4, 0.5, 2.0);
  const FilmState film{mesh.field(1.0), mesh.field(0.7)};
  Matrix residual;
  reynolds_residual({.mesh = mesh, .bearing_number = -3.0}, film, residual);
  const FilmFlows flows = film_flows(mesh, residual);
  EXPECT_NEAR(flows.start, -3.0 * 0.7 * 1.0, 1e-14);  // Lam P H times the whole width
  EXPECT_NEAR(flows.end, flows.start, 1e-14);
  EXPECT_NEAR(flows.sides, 0.0, 1e-14);
}

TEST(FilmFlows, GoOutAtTheSidesWherePressureIsHigherInside) {
  const FilmMesh mesh = make_closed_mesh(8, 4, 0.5);
  FilmState film{mesh.field(1.5), mesh.field(1.0)};
  film.pressure.row(4).setOnes();
  Matrix residual;
  reynolds_residual({.mesh = mesh}, film, residual);
  const FilmFlows flows = film_flows(mesh, residual);
  // P_f dP/dzeta over the circle, at both sides.
  EXPECT_NEAR(flows.sides, 2.0 * 1.25 * 0.5 / mesh.dzeta * 2.0 * std::numbers::pi, 1e-12);
  EXPECT_EQ(flows.start, 0.0);
}

TEST(ThinnestPlace, IsTheVertexOfAParabola) {
  const FilmMesh mesh = make_slotted_mesh(20, 2, 0.5, 4.0);
  Matrix H = mesh.field(0.3);
  H.rowwise() += (0.8 * (mesh.angles().array() - 2.13).square()).matrix().transpose();
  const ThinnestPlace place = thinnest_place(mesh, H);
  EXPECT_EQ(place.column, 11);  // 2.2
  EXPECT_NEAR(place.thickness, 0.3 + 0.8 * 0.07 * 0.07, 1e-14);
  EXPECT_NEAR(place.vertex_thickness, 0.3, 1e-14);
  EXPECT_NEAR(place.vertex_theta, 2.13, 1e-12);
}

TEST(ThinnestPlace, MayBeAnEdgeOrLieAcrossTheJoint) {
  const FilmMesh slotted = make_slotted_mesh(20, 2, 0.5, 4.0);
  Matrix H = slotted.field(1.0);
  H.rowwise() += slotted.angles().transpose();
  EXPECT_EQ(thinnest_place(slotted, H).column, 0);
  EXPECT_EQ(thinnest_place(slotted, H).vertex_thickness, 1.0);

  const FilmMesh closed = make_closed_mesh(20, 2, 0.5);
  const ThinnestPlace place = thinnest_place(closed, eccentric_thickness(closed, 0.5, std::numbers::pi + 0.1));
  EXPECT_EQ(place.column, 0);
  EXPECT_NEAR(place.vertex_thickness, 0.5, 1e-3);  // a parabola approximates the cosine: dtheta^4 / 24
  EXPECT_NEAR(place.vertex_theta, 0.1, 2e-3);
}

}  // namespace
}  // namespace bumpfoil
