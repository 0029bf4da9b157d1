#include "bumpfoil/film/film_solver.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/film/film_energy.hpp"
#include "bumpfoil/film/film_integrals.hpp"
#include "support/film_cases.hpp"

namespace bumpfoil {
namespace {

const FilmMesh slotted = make_slotted_mesh(40, 5, 1.0, 6.24);

TEST(Foundation, YieldsToThePressureItself) {
  Matrix H = slotted.field(1.0);
  Matrix excess = slotted.field(0.0);
  excess(1, 7) = 0.5;
  add_yield({FoundationKind::pointwise, 0.4}, slotted, excess, H);
  EXPECT_DOUBLE_EQ(H(1, 7), 1.2);
  EXPECT_EQ(H.sum(), slotted.field(1.0).sum() + 0.2);
  add_yield({FoundationKind::rigid, 0.4}, slotted, excess, H);
  EXPECT_DOUBLE_EQ(H(1, 7), 1.2);
}

TEST(Foundation, YieldsToTheMeanOverTheWidth) {
  Matrix H = slotted.field(1.0);
  Matrix excess = slotted.field(0.0);
  excess.col(7).setConstant(0.5);  // a mean of 0.5
  excess(0, 9) = 0.5;              // half a cell out of five
  add_yield({FoundationKind::axial_mean, 0.4}, slotted, excess, H);
  for (int j = 0; j <= 5; ++j) {
    EXPECT_DOUBLE_EQ(H(j, 7), 1.2);
    EXPECT_DOUBLE_EQ(H(j, 9), 1.0 + 0.4 * 0.05);
    EXPECT_EQ(H(j, 8), 1.0);
  }
}

TEST(FilmSolver, CutsStepsThatTakeTooMuch) {
  const FilmSolverOptions options;  // at least 0.3 remains, H changes by at most 1
  const Matrix one = slotted.field(1.0);
  const FilmState film{one, 2.0 * one};
  FilmState step{0.0 * one, 0.0 * one};
  step.pressure(2, 3) = 5.0;  // any increase of P is accepted
  EXPECT_EQ(longest_step(options, film, step), 1.0);
  step.pressure(1, 7) = -1.4;
  EXPECT_DOUBLE_EQ(longest_step(options, film, step), 0.5);  // 0.7 of 1.4
  step.thickness(1, 9) = -3.5;
  EXPECT_DOUBLE_EQ(longest_step(options, film, step), 1.0 / 3.5);
  step.thickness(2, 9) = 8.0;
  EXPECT_DOUBLE_EQ(longest_step(options, film, step), 0.125);
  EXPECT_DOUBLE_EQ(longest_step({.kept_fraction = 0.9}, film, step), 0.1 / 1.75);  // limited by the decrease of H
}

/// For all meshes and foundations the residual is zero up to round-off, and H follows from the foundation.
TEST(FilmSolver, SolvesTheEquations) {
  for (const FilmMesh& mesh : {slotted, make_closed_mesh(40, 5, 1.0), make_closed_mesh(40, 8, 0.5),
                               make_closed_mesh(40, 7, 0.5, WidthPart::whole)}) {
    for (const FoundationKind kind : {FoundationKind::rigid, FoundationKind::pointwise, FoundationKind::axial_mean}) {
      const Foundation foundation{kind, 0.3};
      FilmSolver solver(mesh, foundation);
      const ReynoldsEquation equation{.mesh = mesh, .bearing_number = 3.0, .knudsen = 0.01};
      const Matrix rigid = eccentric_thickness(mesh, 0.6, 0.3);
      FilmState film{mesh.field(1.0), {}};
      const FilmReport report = solver.solve(equation, rigid, film);
      ASSERT_EQ(report.status, Status::converged);
      EXPECT_LE(report.iterations, 9);  // quadratic convergence at the end: wrong derivatives need more
      Matrix residual;
      reynolds_residual(equation, film, residual);
      EXPECT_LT(mesh.unknown(residual).cwiseAbs().maxCoeff(), 1e-14);
      Matrix H = rigid;
      add_yield(foundation, mesh, film.pressure - mesh.field(1.0), H);
      EXPECT_LT((H - film.thickness).cwiseAbs().maxCoeff(), 1e-14);
      EXPECT_GT(film.pressure.minCoeff(), 0.0);
    }
  }
}

/// A symmetric film on the whole width has mirror-image halves, and its integrals are twice those of the half width.
TEST(FilmSolver, FindsHalvesThatAreAlikeOnTheWholeWidth) {
  const FilmMesh half = make_slotted_mesh(30, 5, 1.0, 5.5);
  const FilmMesh whole = make_slotted_mesh(30, 10, 1.0, 5.5, WidthPart::whole);
  const auto solved = [](const FilmMesh& mesh) {
    FilmSolver solver(mesh, {FoundationKind::axial_mean, 0.3});
    const ReynoldsEquation equation{.mesh = mesh, .bearing_number = 3.0, .knudsen = 0.01};
    FilmState film{mesh.field(1.0), {}};
    EXPECT_EQ(solver.solve(equation, eccentric_thickness(mesh, 0.6, 0.3), film).status, Status::converged);
    return film;
  };
  const FilmState film = solved(half);
  const FilmState both = solved(whole);
  EXPECT_LT((both.pressure.bottomRows(6) - film.pressure).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((both.pressure - both.pressure.colwise().reverse()).cwiseAbs().maxCoeff(), 1e-12);
  const auto sums = [](const FilmMesh& mesh, const FilmState& state) {
    const ReynoldsEquation equation{.mesh = mesh, .bearing_number = 3.0, .knudsen = 0.01};
    const FilmIntegrals integrals = film_integrals(equation, state);
    Matrix residual;
    reynolds_residual(equation, state, residual);
    const FilmFlows flows = film_flows(mesh, residual);
    const FilmPowers powers = film_powers(equation, state);
    return Vector{{integrals.cosine, integrals.sine, integrals.couette, integrals.poiseuille, integrals.dissipation,
                   flows.start, flows.end, flows.sides, powers.entrained, powers.dissipated, powers.supplied,
                   free_energy(mesh, state)}};
  };
  const Vector expected = sums(half, film);
  EXPECT_LT((sums(whole, both) - expected).cwiseAbs().maxCoeff(), 1e-11 * expected.cwiseAbs().maxCoeff());
  EXPECT_GT(expected.cwiseAbs().head(8).minCoeff(), 1e-2);
}

TEST(FilmSolver, KeepsTheGivenPressuresAtTheEdges) {
  FilmSolver solver(slotted, {});
  const ReynoldsEquation equation{.mesh = slotted, .bearing_number = 0.0};
  FilmState film{slotted.field(1.0), {}};
  film.pressure.col(0).setConstant(1.4);
  ASSERT_EQ(solver.solve(equation, slotted.field(1.0), film).status, Status::converged);
  EXPECT_EQ(film.pressure.col(0), Vector::Constant(6, 1.4));
  EXPECT_EQ(film.pressure.col(40), Vector::Ones(6));
  EXPECT_GT(film.pressure(0, 1), 1.2);
}

TEST(FilmSolver, SaysWhenThereIsNoRoom) {
  FilmSolver solver(slotted, {FoundationKind::pointwise, 1.0});
  FilmState film{slotted.field(1.0), slotted.field(7.0)};
  const FilmReport report =
      solver.solve({.mesh = slotted, .bearing_number = 1.0}, eccentric_thickness(slotted, 1.2), film);
  EXPECT_EQ(report.status, Status::no_room);
  EXPECT_EQ(film.thickness, slotted.field(7.0));
}

TEST(FilmSolver, SaysWhenSurfacesTouch) {
  FilmSolver solver(slotted, {}, {.thickness_floor = 0.45});
  FilmState film{slotted.field(1.0), {}};
  const ReynoldsEquation equation{.mesh = slotted, .bearing_number = 1.0};
  EXPECT_EQ(solver.solve(equation, eccentric_thickness(slotted, 0.5), film).status, Status::converged);
  EXPECT_EQ(solver.solve(equation, eccentric_thickness(slotted, 0.6), film).status, Status::touchdown);
}

TEST(FilmSolver, GivesUpAndLeavesTheFilmAsItWas) {
  FilmSolver solver(slotted, {}, {.max_iterations = 2});
  FilmState film{slotted.field(1.0), slotted.field(7.0)};
  const FilmReport report =
      solver.solve({.mesh = slotted, .bearing_number = 20.0}, eccentric_thickness(slotted, 0.8), film);
  EXPECT_EQ(report.status, Status::not_converged);
  EXPECT_EQ(report.iterations, 2);
  EXPECT_EQ(film.pressure, slotted.field(1.0));
  EXPECT_EQ(film.thickness, slotted.field(7.0));
}

/// A compliant foundation at an eccentricity beyond the clearance: no film to start from there.
TEST(FilmSolver, FollowsAFilmToWhereNoStartIsNear) {
  FilmSolver solver(slotted, {FoundationKind::axial_mean, 1.0});
  const ReynoldsEquation equation{.mesh = slotted, .bearing_number = -1.85};
  const Matrix near = eccentric_thickness(slotted, 0.5);
  const Matrix far = eccentric_thickness(slotted, 1.5);
  FilmState film{slotted.field(1.0), {}};
  ASSERT_EQ(solver.solve(equation, near, film).status, Status::converged);
  ASSERT_EQ(solver.follow(equation, near, far, film).status, Status::converged);
  EXPECT_GT(film.thickness.minCoeff(), 0.2);
  FilmState again = film;
  const FilmReport report = solver.solve(equation, far, again);
  EXPECT_EQ(report.iterations, 1);  // started at the solution
  EXPECT_LT((again.pressure - film.pressure).cwiseAbs().maxCoeff(), 1e-9);
}

/// Implicit time steps with a constant wall converge to the steady film.
TEST(FilmSolver, MarchesToTheSteadyFilm) {
  FilmSolver solver(slotted, {});
  ReynoldsEquation equation{.mesh = slotted, .bearing_number = 5.0, .squeeze_rate = 4.0};
  const Matrix H = eccentric_thickness(slotted, 0.5);
  FilmState film{slotted.field(1.0), H};
  double first_load = 0.0;
  for (int step = 0; step < 60; ++step) {
    equation.previous_content = film_content(film);
    ASSERT_EQ(solver.solve(equation, H, film).status, Status::converged);
    if (step == 0) first_load = film_integrals(equation, film).cosine;
  }
  const SolvedFilm steady = solve_rigid_film({.mesh = slotted, .bearing_number = 5.0}, H);
  EXPECT_LT((film.pressure - steady.film.pressure).cwiseAbs().maxCoeff(), 1e-6);  // remainder after sixty time steps
  const double load = film_integrals(equation, film).cosine;
  EXPECT_GT(std::abs(first_load - load), 0.1 * std::abs(load));  // the first film is not yet the steady one
}

TEST(FilmReport, AddsWhatComesAfterIt) {
  FilmReport report{.status = Status::touchdown, .iterations = 2, .factorisations = 30, .residual = 0.5, .jumps = 1};
  report += {.status = Status::converged, .iterations = 5, .factorisations = 70, .residual = 0.25, .jumps = 3};
  EXPECT_EQ(report.status, Status::converged);
  EXPECT_EQ(report.iterations, 7);
  EXPECT_EQ(report.factorisations, 100);
  EXPECT_EQ(report.residual, 0.25);
  EXPECT_EQ(report.jumps, 4);
}

}  // namespace
}  // namespace bumpfoil
