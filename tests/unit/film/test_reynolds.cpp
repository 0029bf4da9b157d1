#include "bumpfoil/film/reynolds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "film/faces.hpp"

namespace bumpfoil {
namespace {

/// Pressures and thicknesses without symmetry, between 0.5 and 1.5.
FilmState wavy_film(const FilmMesh& mesh) {
  FilmState film{mesh.field(1.0), mesh.field(1.0)};
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j <= mesh.rows; ++j) {
      film.pressure(j, k) += 0.5 * std::sin(1.0 + 3.0 * j + 2.0 * k * k);
      film.thickness(j, k) += 0.5 * std::cos(2.0 + 5.0 * j + 3.0 * k * k);
    }
  }
  return film;
}

std::vector<ReynoldsEquation> equations() {
  std::vector<ReynoldsEquation> all;
  for (const FilmMesh& mesh : {make_closed_mesh(5, 3, 0.7), make_slotted_mesh(6, 3, 0.7, 5.0)}) {
    for (const double Lam : {-40.0, -1.9, 0.0, 0.3, 20.0}) {  // from central to upwind
      for (const double Kn : {0.0, 0.03}) {
        all.push_back({.mesh = mesh, .bearing_number = Lam, .knudsen = Kn});
        all.push_back({mesh, Lam, Kn, 1.7, mesh.field(0.9)});  // with the squeeze term
      }
    }
  }
  return all;
}

/// Derivative of all residuals with respect to one entry of `field`, which belongs to `film`, by central differences.
Matrix difference(const ReynoldsEquation& equation, FilmState& film, double& entry, double step) {
  Matrix plus, minus;
  const double value = entry;
  entry = value + step;
  reynolds_residual(equation, film, plus);
  entry = value - step;
  reynolds_residual(equation, film, minus);
  entry = value;
  return (plus - minus) / (2.0 * step);
}

/// The same derivatives from the stencils.
Matrix derivative(const FilmMesh& mesh, const FilmStencil& stencil, int j, int k) {
  Matrix d = mesh.field(0.0);
  const int n = mesh.nodes();
  d(j, k) = stencil.own(j, k);
  if (mesh.closed || k > 0) d(j, (k + n - 1) % n) = stencil.after(j, (k + n - 1) % n);
  if (mesh.closed || k + 1 < n) d(j, (k + 1) % n) = stencil.before(j, (k + 1) % n);
  if (j > 0) d(j - 1, k) = stencil.outside(j - 1, k);
  if (j < mesh.rows) d(j + 1, k) = stencil.inside(j + 1, k);
  return d;
}

/// Largest difference between the derivatives and central differences with `step`, relative to the largest derivative.
double worst_difference(const ReynoldsEquation& equation, double step) {
  const FilmMesh& mesh = equation.mesh;
  FilmState film = wavy_film(mesh);
  Matrix residual;
  FilmJacobian jacobian;
  linearise_reynolds(equation, film, residual, jacobian);
  double worst = 0.0;
  double largest = 0.0;
  for (int k = 0; k < mesh.nodes(); ++k) {
    for (int j = 0; j <= mesh.rows; ++j) {
      const Matrix by_pressure = derivative(mesh, jacobian.by_pressure, j, k);
      const Matrix by_thickness = derivative(mesh, jacobian.by_thickness, j, k);
      const Matrix p = difference(equation, film, film.pressure(j, k), step);
      const Matrix h = difference(equation, film, film.thickness(j, k), step);
      worst = std::max({worst, (p - by_pressure).cwiseAbs().maxCoeff(), (h - by_thickness).cwiseAbs().maxCoeff()});
      largest = std::max({largest, by_pressure.cwiseAbs().maxCoeff(), by_thickness.cwiseAbs().maxCoeff()});
    }
  }
  return worst / largest;
}

TEST(Reynolds, DerivativesAgreeWithDifferencesOverDecades) {
  for (const ReynoldsEquation& equation : equations()) {
    // The truncation error falls with the square of the step down to 1e-10; round-off grows with its inverse.
    EXPECT_LT(worst_difference(equation, 1e-2), 1e-2);
    EXPECT_LT(worst_difference(equation, 1e-3), 1e-4);
    EXPECT_LT(worst_difference(equation, 1e-4), 1e-6);
    EXPECT_LT(worst_difference(equation, 1e-5), 1e-8) << equation.bearing_number << ' ' << equation.knudsen;
  }
}

TEST(Reynolds, StencilsTimesAChangeIsTheChangeOfResiduals) {
  for (const ReynoldsEquation& equation : equations()) {
    const FilmMesh& mesh = equation.mesh;
    Matrix residual;
    FilmJacobian jacobian;
    linearise_reynolds(equation, wavy_film(mesh), residual, jacobian);
    Matrix expected = mesh.field(0.0);
    Matrix change = mesh.field(0.0);
    for (int k = 0; k < mesh.nodes(); ++k) {
      for (int j = 0; j <= mesh.rows; ++j) {
        change(j, k) = std::sin(1.0 + j + 5.0 * k);
        expected += change(j, k) * derivative(mesh, jacobian.by_thickness, j, k);
      }
    }
    const Matrix product = stencil_product(mesh, jacobian.by_thickness, change);
    EXPECT_LT((product - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
  }
}

TEST(Reynolds, BothFunctionsGiveTheSameResidual) {
  for (const ReynoldsEquation& equation : equations()) {
    const FilmState film = wavy_film(equation.mesh);
    Matrix alone, beside;
    FilmJacobian jacobian;
    reynolds_residual(equation, film, alone);
    linearise_reynolds(equation, film, beside, jacobian);
    EXPECT_EQ(alone, beside);
  }
}

TEST(Reynolds, ResidualsOfASteadyFilmSumToZero) {
  for (ReynoldsEquation equation : equations()) {
    equation.squeeze_rate = 0.0;
    Matrix residual;
    reynolds_residual(equation, wavy_film(equation.mesh), residual);
    EXPECT_NEAR(residual.sum(), 0.0, 1e-12);  // flow out of a volume enters another, up to round-off
  }
}

TEST(Reynolds, StoresWhatAVolumeHoldsMore) {
  const FilmMesh mesh = make_slotted_mesh(4, 2, 0.5, 2.0);
  ReynoldsEquation equation{.mesh = mesh, .squeeze_rate = 3.0, .previous_content = mesh.field(1.0)};
  const FilmState film{mesh.field(1.1), mesh.field(1.2)};
  Matrix residual;
  reynolds_residual(equation, film, residual);
  EXPECT_NEAR(residual.sum(), 3.0 * (1.1 * 1.2 - 1.0) * 2.0 * 0.5, 1e-14);
  EXPECT_NEAR(residual(0, 0), 3.0 * 0.32 * 0.25 * mesh.dtheta * mesh.dzeta, 1e-15);  // a corner: a quarter of a cell
  EXPECT_EQ(film_content(film), mesh.field(1.1 * 1.2));
}

TEST(Reynolds, TurningTheSpeedRoundTurnsTheFilmRound) {
  const FilmMesh mesh = make_slotted_mesh(6, 3, 0.7, 5.0);
  const FilmState film = wavy_film(mesh);
  const FilmState turned{film.pressure.rowwise().reverse(), film.thickness.rowwise().reverse()};
  Matrix residual, reversed;
  reynolds_residual({.mesh = mesh, .bearing_number = 7.0}, film, residual);
  reynolds_residual({.mesh = mesh, .bearing_number = -7.0}, turned, reversed);
  EXPECT_LT((residual - reversed.rowwise().reverse()).cwiseAbs().maxCoeff(), 1e-14);  // sums in a different order
}

TEST(Reynolds, FluxOfAUniformFilmIsThatOfCouetteFlow) {
  const FilmNode node{1.3, 0.7};
  for (const double Lam : {-5.0, 0.0, 5.0}) {
    EXPECT_DOUBLE_EQ(column_flux(node, node, Lam, 0.01, 0.1).value, Lam * 1.3 * 0.7);
  }
  // Poiseuille flow: - (H^3 P + 6 Kn H^2) dP/dzeta at the mean.
  EXPECT_DOUBLE_EQ(row_flux({1.0, 2.0}, {1.2, 2.0}, 0.05, 0.1).value, -(8.0 * 1.1 + 6.0 * 0.05 * 4.0) * 2.0);
}

TEST(Reynolds, UpwindingSufficesForPositivePressures) {
  for (double X = 1e-3; X < 1e12; X *= 1.1) {
    const UpwindWeight l(X);
    EXPECT_GE(l.value, 1.0 - 1.0 / X - 1e-15);  // both approach 1 up to round-off
    EXPECT_LE(l.value, 1.0);
    EXPECT_GE(l.slope, 0.0);
  }
  EXPECT_DOUBLE_EQ(UpwindWeight(std::nextafter(1.0, 0.0)).value, UpwindWeight(1.0).value);
  EXPECT_DOUBLE_EQ(UpwindWeight(std::nextafter(1.0, 0.0)).slope, UpwindWeight(1.0).slope);
  EXPECT_EQ(UpwindWeight(std::numeric_limits<double>::infinity()).value, 1.0);
  EXPECT_NEAR(UpwindWeight(1e-3).value, 1e-12, 2e-15);  // X^4: second order stays exact
}

/// With frozen coefficients, the matrix that multiplies P has positive diagonal entries, non-positive others, and
/// column sums equal to the outflow at edges: it ensures P > 0.
TEST(Reynolds, FrozenCoefficientsMakeAnMMatrix) {
  for (const double Lam : {-200.0, -3.0, 0.4, 3.0, 200.0}) {
    const FilmNode a{0.8, 0.3};
    const FilmNode b{1.7, 0.9};
    constexpr double dtheta = 0.2;
    const Conductance G(a, b, 0.0);
    const UpwindWeight l(0.5 * std::abs(Lam) * (Lam > 0.0 ? b : a).thickness * dtheta / G.value);
    const double out_of_a = 0.5 * (Lam + std::abs(Lam) * l.value) * a.thickness + G.value / dtheta;
    const double into_a = 0.5 * (Lam - std::abs(Lam) * l.value) * b.thickness - G.value / dtheta;
    EXPECT_GE(out_of_a, 0.0) << Lam;
    EXPECT_LE(into_a, 0.0) << Lam;
    EXPECT_NEAR(column_flux(a, b, Lam, 0.0, dtheta).value, out_of_a * a.pressure + into_a * b.pressure, 1e-11);
  }
}

}  // namespace
}  // namespace bumpfoil
