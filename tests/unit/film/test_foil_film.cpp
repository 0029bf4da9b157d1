#include "bumpfoil/film/foil_film.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bumpfoil/structure/top_foil.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

const FilmScales scales{{.viscosity = 1.85e-5, .ambient_pressure = 101325.0}, 19.05e-3, 31.8e-6};
constexpr double stiffness = 7.9e-4;  // EI', N m^2
constexpr double pitch = 4.572e-3;

/// A top foil over `spans` supports, m columns from one to the next, the first and the last span half as long.
/// @param further  columns from each support to an additional one; 0: none
FoilFilm example_film(int spans, int m, int rows, int modes = 1, WidthPart width = WidthPart::half, int further = 0) {
  std::vector<int> supports;
  for (int i = 0; i < spans; ++i) {
    supports.push_back(m / 2 + i * m);
    if (further > 0) supports.push_back(supports.back() + further);
  }
  const FilmMesh mesh = make_slotted_mesh(spans * m, rows, 1.0, spans * pitch / scales.radius, width);
  return make_foil_film(mesh, scales, stiffness, pitch, supports, {},
                        {.modes = modes, .stretching = 2.2e7, .poisson_ratio = 0.29});
}

/// A state without symmetry, thickness 1 + U.
FoilFilmState wavy(const FoilFilm& foil) {
  FoilFilmState state = undeformed(foil, foil.mesh.field(1.0));
  const int n = foil.mesh.columns;
  for (int k = 1; k <= n; ++k) {
    for (int s = 0; s < state.deflection.rows(); ++s) state.deflection(s, k) = 0.3 * std::sin(0.7 * k * k + s);
    if (k < n) {
      for (int j = foil.mesh.first_unknown_row(); j < foil.mesh.rows; ++j) {
        state.pressure(j, k) += 0.4 * std::sin(1.0 + j + 2.0 * k * k);
      }
    }
  }
  for (int k = 0; k < n; ++k) {
    for (int s = 0; s < state.moment.rows(); ++s) state.moment(s, k) = std::cos(1.3 * k * k + s);
    for (int i = 0; i < state.membrane.rows(); ++i) state.membrane(i, k) = std::sin(1.1 * k * k + i);
  }
  state.thickness += foil.shapes * state.deflection;
  return state;
}

void add(const FoilFilmState& step, double factor, FoilFilmState& state) {
  state.pressure += factor * step.pressure;
  state.thickness += factor * step.thickness;
  state.deflection += factor * step.deflection;
  state.moment += factor * step.moment;
  state.membrane += factor * step.membrane;
}

/// Solves the condensed equations as a dense system, without support forces.
Matrix solve_condensed(const FoilFilm& foil, FoilFilmSystem& system, const Matrix& condensed) {
  const Eigen::Index n = system.block_size();
  const Eigen::Index blocks = system.blocks();
  Matrix A = Matrix::Zero(n * blocks, n * blocks);
  Vector right(n * blocks);
  for (Eigen::Index i = 0; i < blocks; ++i) {
    const int b = static_cast<int>(i);
    A.block(i * n, i * n, n, n) = system.diagonal(b);
    if (i > 0) A.block(i * n, (i - 1) * n, n, n) = system.lower(b);
    if (i + 1 < blocks) A.block(i * n, (i + 1) * n, n, n) = system.upper(b);
    right.segment(i * n, n) = -condensed.col(i);
  }
  const auto keep_zero = [&](Eigen::Index row) {
    A.row(row).setZero();
    A(row, row) = 1.0;
    right[row] = 0.0;
  };
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Index pressures = foil.mesh.unknown_rows();
    const bool is_U = j >= pressures && j < pressures + foil.lines.count();
    if (!is_U) keep_zero((blocks - 1) * n + j);  // at the free end only U is unknown
  }
  const Vector solution = solve(A, right);
  return Eigen::Map<const Matrix>(solution.data(), n, blocks);
}

TEST(FoilFilmSystem, FindsNewtonsStep) {
  struct Film {
    double Lam{};
    int modes{1};
    WidthPart width{};
    int further{};
  };
  constexpr WidthPart whole = WidthPart::whole;
  for (const auto& [Lam, modes, width, further] :
       {Film{-1.9}, Film{8.0}, Film{-1.9, 3}, Film{8.0, 5}, Film{8.0, 1, whole}, Film{-1.9, 2, whole},
        Film{-1.9, 3, whole}, Film{8.0, 3, whole}, Film{8.0, 3, whole, 1}}) {
    FoilFilm foil = example_film(4, 6, width == whole ? 5 : 3, modes, width, further);
    // Asperities high enough to touch at all nodes, and stiffer than a span.
    if (Lam > 0.0) foil.asperities = Asperities{.pressure_factor = 3.0, .roughness = 0.5};
    const ReynoldsEquation equation{.mesh = foil.mesh, .bearing_number = Lam, .knudsen = 0.01};
    const FoilFilmState state = wavy(foil);
    FoilFilmSystem system(foil);
    FoilFilmResidual residual;
    foil_film_residual(foil, equation, state, residual);
    ASSERT_TRUE(system.linearise(equation, state));
    FoilFilmState step;
    system.condense({&residual, 1});
    system.expand(solve_condensed(foil, system, system.condensed()), {&step, 1});
    EXPECT_EQ(step.deflection.col(0).norm(), 0.0);
    EXPECT_EQ(step.moment.col(foil.mesh.columns).norm(), 0.0);

    // Along the step all residuals decrease in proportion, with a second-order error.
    constexpr double h = 1e-6;
    FoilFilmResidual plus, minus;
    FoilFilmState moved = state;
    add(step, h, moved);
    foil_film_residual(foil, equation, moved, plus);
    add(step, -2.0 * h, moved);
    foil_film_residual(foil, equation, moved, minus);
    const auto expect_falls = [](const auto& r, const auto& p, const auto& m) {
      EXPECT_LT(((p - m) / (2.0 * h) + r).cwiseAbs().maxCoeff(), 1e-5 * r.cwiseAbs().maxCoeff());
    };
    const auto interior = [&](const Matrix& field) { return Matrix(foil.mesh.unknown(field)); };
    expect_falls(interior(residual.film), interior(plus.film), interior(minus.film));
    expect_falls(residual.balance, plus.balance, minus.balance);
    expect_falls(residual.compatibility, plus.compatibility, minus.compatibility);
    if (!foil.membrane.empty()) expect_falls(residual.membrane, plus.membrane, minus.membrane);
  }
}

/// Displacements and moments under an `excess` pressure at all columns except the ends, with U = 0 at the supports,
/// from the dense compliance of a cantilever.
FoilFilmState pressed(const FoilFilm& foil, double excess) {
  const FilmMesh& mesh = foil.mesh;
  const TopFoilBeam beam{scales.radius, stiffness, mesh.angles().tail(mesh.columns)};
  const Matrix S = top_foil_compliance(beam);
  // N per column: the side row carries half a cell at ambient pressure.
  const double width = 2.0 * scales.radius * mesh.dzeta * (mesh.rows - 0.5);
  Vector load =
      Vector::Constant(mesh.columns, excess * scales.gas.ambient_pressure * width * scales.radius * mesh.dtheta);
  load[mesh.columns - 1] = 0.0;
  std::vector<Eigen::Index> held;
  for (const int column : foil.supports) held.push_back(column - 1);
  const Vector free = S * load;
  const Vector reaction = solve(S(held, held), Vector(-free(held)));
  const Vector u = free + S(Eigen::all, held) * reaction;
  FoilFilmState state = undeformed(foil, mesh.field(1.0));
  state.deflection.rightCols(mesh.columns) = u.transpose() / scales.thickness;
  state.moment.leftCols(mesh.columns) =
      top_foil_moments(foil.top_foil, u).transpose() * pitch * pitch / (stiffness * scales.thickness);
  state.pressure.block(0, 1, mesh.rows, mesh.columns - 1).array() += excess;
  return state;
}

TEST(FoilFilm, BalancesTheLoadsOfTheFilmLikeTheComplianceForm) {
  const FoilFilm foil = example_film(6, 6, 4);
  const FoilFilmState state = pressed(foil, 0.5);
  FoilFilmResidual residual;
  foil_residual(foil, state, residual);
  const double load = foil.load_scale * 3.5 * 0.5;
  for (const int column : foil.supports) {
    EXPECT_GT(std::abs(residual.balance(column)), load);  // the support forces
    residual.balance(column) = 0.0;
  }
  // The dense compliance of 36 nodes has a condition number of 1e7.
  EXPECT_LT(residual.balance.cwiseAbs().maxCoeff(), 1e-7 * load);
  EXPECT_LT(residual.compatibility.cwiseAbs().maxCoeff(), 1e-8 * state.deflection.cwiseAbs().maxCoeff());
}

TEST(FoilFilm, CarriesItsOverhangByTheMomentOverTheLastSupport) {
  const FoilFilm foil = example_film(6, 6, 4);
  const FoilFilmState state = pressed(foil, 0.5);
  // Loads on the two columns behind the last support, and none at the free end.
  const double load = foil.load_scale * 3.5 * 0.5;
  const double arm = scales.radius / pitch * (std::sin(foil.mesh.dtheta) + std::sin(2.0 * foil.mesh.dtheta));
  EXPECT_NEAR(state.moment(foil.supports.back()), load * arm, 1e-6 * load);
  EXPECT_NEAR(state.moment(foil.mesh.columns - 1), 0.0, 1e-6 * load);
}

/// Between supports the foil sags like a curved beam under uniform pressure:
/// u = (R^2/EI') (M_a chi_a + M_b chi_b) + (R^4 q/EI') (1 - phi_a - phi_b - chi_a - chi_b).
TEST(FoilFilm, SagsAsTheClosedFormSays) {
  double defect[2];
  for (const int i : {0, 1}) {
    const int m = 12 << i;
    const FoilFilm foil = example_film(6, m, 4);
    const FoilFilmState state = pressed(foil, 0.5);
    const double R = scales.radius;
    const double q = 0.5 * scales.gas.ambient_pressure * 2.0 * R * foil.mesh.dzeta * 3.5;
    const double to_moment = stiffness * scales.thickness / (pitch * pitch);
    const int first = foil.supports[2];
    const double d = m * foil.mesh.dtheta;
    const double s = 0.5 * d;
    const double phi = std::sin(s) / std::sin(d);
    const double chi = (s * std::cos(d - s) - d * std::sin(s) / std::sin(d)) / (2.0 * std::sin(d));
    const double ends = (state.moment(first) + state.moment(first + m)) * to_moment;
    const double sag = R * R / stiffness * ends * chi + R * R * R * R * q / stiffness * (1.0 - 2.0 * phi - 2.0 * chi);
    const double found = state.deflection(first + m / 2) * scales.thickness;
    EXPECT_GT(sag, 1e-8);
    defect[i] = found / sag - 1.0;
  }
  EXPECT_LT(std::abs(defect[0]), 0.04);  // twelve lumped loads
  EXPECT_NEAR(defect[0] / defect[1], 4.0, 0.5);
}

TEST(FoilFilm, RestsUndeformedAtAmbientPressure) {
  const FoilFilm foil = example_film(3, 4, 2);
  const FoilFilmState state = undeformed(foil, foil.mesh.field(0.7));
  FoilFilmResidual residual;
  foil_film_residual(foil, {.mesh = foil.mesh}, state, residual);
  EXPECT_EQ(residual.film, foil.mesh.field(0.0));
  EXPECT_EQ(residual.balance.norm(), 0.0);
  EXPECT_EQ(residual.compatibility.norm(), 0.0);
  EXPECT_DOUBLE_EQ(foil.mesh.angles()[12], 3 * pitch / scales.radius);
  EXPECT_LT(foil.mesh.angles()[12], 2.0 * std::numbers::pi);
}

}  // namespace
}  // namespace bumpfoil
