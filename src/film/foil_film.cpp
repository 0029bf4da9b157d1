#include "bumpfoil/film/foil_film.hpp"

#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "film/foil_columns.hpp"
#include "film/foil_span.hpp"

namespace bumpfoil {

FoilFilm make_foil_film(const FilmMesh& mesh, const FilmScales& scales, double bending_stiffness, double pitch,
                        std::vector<int> supports, const Forming& forming) {
  BUMPFOIL_ASSERT(!mesh.closed && !supports.empty());
  FoilFilm foil;
  foil.mesh = mesh;
  const TopFoilBeam beam{
      .radius = scales.radius, .bending_stiffness = bending_stiffness, .theta = mesh.angles().tail(mesh.columns)};
  foil.top_foil = make_top_foil_moments(beam);
  foil.forming = pitch / scales.thickness * forming_rotations(beam, forming);
  foil.pitch = pitch;
  foil.stiffness = bending_stiffness / (pitch * pitch * pitch);
  foil.load_scale = 2.0 * scales.force() * mesh.dtheta * mesh.dzeta / (scales.thickness * foil.stiffness);
  foil.supports = std::move(supports);
  return foil;
}

namespace {

/// Values of asperities at all columns. @param value  (asperities, H) -> number
template <typename Value>
Vector over_columns(const FoilFilm& foil, const Matrix& thickness, Value&& value) {
  Vector values = Vector::Zero(foil.mesh.nodes());
  if (!foil.asperities) return values;
  for (int k = 0; k < foil.mesh.nodes(); ++k) values[k] = value(*foil.asperities, thickness(0, k));
  return values;
}

}  // namespace

Vector asperity_pressures(const FoilFilm& foil, const Matrix& thickness) {
  return over_columns(foil, thickness, [](const Asperities& rough, double H) { return rough.pressure(H); });
}

Vector asperity_balance(const FoilFilm& foil, Vector pressures) {
  const double of_rows = -foil.load_scale * foil.mesh.rows;  // all weights of rows together
  for (int k = 0; k < foil.mesh.nodes(); ++k) pressures[k] *= of_rows * foil.mesh.column_weight(k);
  pressures[0] = 0.0;  // the weld carries it
  return pressures;
}

FoilFilmState undeformed(const FoilFilm& foil, const Matrix& thickness) {
  return {{foil.mesh.field(1.0), thickness}, Vector::Zero(foil.mesh.nodes()), Vector::Zero(foil.mesh.nodes())};
}

void foil_residual(const FoilFilm& foil, const FoilFilmState& state, FoilFilmResidual& residual) {
  const FilmMesh& mesh = foil.mesh;
  residual.balance.setZero(mesh.nodes());
  residual.compatibility.setZero(mesh.nodes());
  const Vector& U = state.lift;
  const Vector& M = state.moment;
  for (int k = 0; k < mesh.nodes(); ++k) {
    const FoilColumn column(foil, k);
    const double U_before = k > 0 ? U[k - 1] : 0.0;
    const double M_before = k > 0 ? M[k - 1] : 0.0;
    if (k > 0) {
      double excess = 0.0;
      for (int j = 0; j <= mesh.rows; ++j) excess += mesh.row_weight(j) * (state.pressure(j, k) - 1.0);
      residual.balance[k] = column.kink_before * (M_before - M[k]) + column.arc * M[k] - column.load * excess;
    }
    if (k == mesh.columns) continue;
    // Differences first: U is smooth where the foil is soft, and its curvature is all that counts.
    if (k > 0) residual.balance[k] += column.kink_after * (M[k + 1] - M[k]);
    residual.compatibility[k] = column.kink_before * (U_before - U[k]) + column.kink_after * (U[k + 1] - U[k]) +
                                column.arc * U[k] - column.bend_before * M_before - column.bend * M[k] -
                                column.bend_after * M[k + 1];
  }
}

void foil_film_residual(const FoilFilm& foil, const ReynoldsEquation& equation, const FoilFilmState& state,
                        FoilFilmResidual& residual) {
  reynolds_residual(equation, state, residual.film);
  foil_residual(foil, state, residual);
  residual.compatibility.head(foil.mesh.columns) -= foil.forming;
  if (foil.asperities) residual.balance += asperity_balance(foil, asperity_pressures(foil, state.thickness));
}

struct FoilFilmSystem::Workspace {
  explicit Workspace(const FoilFilm& foil_film);

  template <typename Own>
  void assemble(int k, ColumnCoupling& before, Own&& own, ColumnCoupling& after) const;
  void read_column(int k, const FoilFilmResidual& residual, Eigen::Ref<Vector> values) const;

  /// Columns between two blocks, or between the weld and the first.
  struct Span {
    int first{};  ///< column
    std::unique_ptr<FoilSpan> columns;
    FoilSpan::Condensed condensed;
    Matrix right;  ///< minus the residuals
    Matrix solution;
    Vector before, after;  ///< the right-hand side, as the neighbours see it
  };

  FoilFilm foil;
  int rows;  ///< unknowns of a column
  std::vector<Span> spans;
  std::vector<int> columns;                   ///< of the blocks
  std::vector<Block> lower, diagonal, upper;  ///< condensed
  ColumnCoupling nothing;                     ///< beyond the free end
  FilmJacobian jacobian;
  Vector asperity_slopes, asperity_stiffness;
  Matrix film_residual;
  Matrix condensed;
};

FoilFilmSystem::Workspace::Workspace(const FoilFilm& foil_film)
    : foil(foil_film), rows(foil_film.mesh.unknown_rows() + 2), columns(foil_film.supports) {
  columns.push_back(foil.mesh.columns);
  int first = 0;
  for (const int column : columns) {
    const int length = column - first;
    BUMPFOIL_ASSERT(length >= 1);
    Span span;
    span.first = first;
    span.columns = make_foil_span(length, rows, first > 0);
    span.right.resize(rows, length);
    span.before.resize(rows);
    span.after.resize(rows);
    spans.push_back(std::move(span));
    first = column + 1;
  }
  const Block zero = Block::Zero(rows, rows);
  lower.assign(columns.size(), zero);
  diagonal = upper = lower;
  nothing.resize(rows);
  condensed.resize(rows, static_cast<Eigen::Index>(columns.size()));
}

/// Rows of column k: the film per area of a cell, balance, compatibility. Where an unknown is given, its own row says
/// that it does not move. Entries of couplings that are always zero are left so.
template <typename Own>
void FoilFilmSystem::Workspace::assemble(int k, ColumnCoupling& before, Own&& own, ColumnCoupling& after) const {
  const FilmMesh& mesh = foil.mesh;
  const int n = mesh.unknown_rows();
  const int u = n;
  const int m = n + 1;
  own.setZero();
  const bool weld = k == 0;
  const bool free_end = k == mesh.columns;
  if (weld || free_end) {
    for (int j = 0; j < n; ++j) own(j, j) = 1.0;
    own(weld ? u : m, weld ? u : m) = 1.0;
  } else {
    const double per_area = 1.0 / (mesh.dtheta * mesh.dzeta);
    const FilmStencil& P = jacobian.by_pressure;
    const FilmStencil& H = jacobian.by_thickness;
    const auto scale = [&](const Matrix& derivatives, LineVector& entries) {
      for (int j = 0; j < n; ++j) entries[static_cast<std::size_t>(j)] = derivatives(j, k) * per_area;
    };
    scale(P.before, before.own);
    scale(H.before, before.by_lift);
    scale(P.after, after.own);
    scale(H.after, after.by_lift);
    for (int j = 0; j < n; ++j) {
      own(j, j) = P.own(j, k) * per_area;
      if (j > 0) own(j, j - 1) = P.inside(j, k) * per_area;
      if (j + 1 < n) own(j, j + 1) = P.outside(j, k) * per_area;
      own(j, u) = (H.own(j, k) + H.inside(j, k) + H.outside(j, k)) * per_area;
    }
  }
  const FoilColumn column(foil, k);
  const auto U = static_cast<std::size_t>(u);
  const auto M = static_cast<std::size_t>(m);
  if (!weld) {
    before.by_moment[U] = column.kink_before;
    own(u, u) = asperity_stiffness[k];
    if (!free_end) {
      for (int j = 0; j < n; ++j) own(u, j) = -column.load * mesh.row_weight(j);
      own(u, m) = column.own();
      after.by_moment[U] = column.kink_after;
    }
  }
  if (!free_end) {
    before.by_lift[M] = column.kink_before;
    before.by_moment[M] = -column.bend_before;
    if (!weld) own(m, u) = column.own();
    own(m, m) = -column.bend;
    after.by_lift[M] = column.kink_after;
    after.by_moment[M] = -column.bend_after;
  }
}

FoilFilmSystem::FoilFilmSystem(const FoilFilm& foil) : workspace_(std::make_unique<Workspace>(foil)) {}
FoilFilmSystem::~FoilFilmSystem() = default;

const FilmJacobian& FoilFilmSystem::film_jacobian() const {
  return workspace_->jacobian;
}
const Vector& FoilFilmSystem::asperity_slopes() const {
  return workspace_->asperity_slopes;
}
int FoilFilmSystem::blocks() const {
  return static_cast<int>(workspace_->columns.size());
}
int FoilFilmSystem::block_size() const {
  return workspace_->rows;
}
const FoilFilmSystem::Block& FoilFilmSystem::lower(int i) const {
  return workspace_->lower[static_cast<std::size_t>(i)];
}
const FoilFilmSystem::Block& FoilFilmSystem::diagonal(int i) const {
  return workspace_->diagonal[static_cast<std::size_t>(i)];
}
const FoilFilmSystem::Block& FoilFilmSystem::upper(int i) const {
  return workspace_->upper[static_cast<std::size_t>(i)];
}

bool FoilFilmSystem::linearise(const ReynoldsEquation& equation, const FoilFilmState& state) {
  Workspace& w = *workspace_;
  linearise_reynolds(equation, state, w.film_residual, w.jacobian);
  w.asperity_slopes =
      over_columns(w.foil, state.thickness, [](const Asperities& rough, double H) { return rough.slope(H); });
  w.asperity_stiffness = asperity_balance(w.foil, w.asperity_slopes);
  const std::size_t blocks = w.columns.size();
  for (std::size_t i = 0; i < blocks; ++i) {
    w.assemble(w.columns[i], w.spans[i].columns->of_after(), w.diagonal[i],
               i + 1 < blocks ? w.spans[i + 1].columns->of_before() : w.nothing);
  }
  for (std::size_t i = 0; i < blocks; ++i) {
    Workspace::Span& span = w.spans[i];
    FoilSpan& columns = *span.columns;
    for (int c = 0; c < columns.columns(); ++c) {
      w.assemble(span.first + c, columns.to_before(c), columns.own(c), columns.to_after(c));
    }
    if (!columns.eliminate(span.condensed)) return false;
    w.diagonal[i] += span.condensed.after;
    if (i == 0) continue;
    w.diagonal[i - 1] += span.condensed.before;
    w.upper[i - 1] = span.condensed.before_by_after;
    w.lower[i] = span.condensed.after_by_before;
  }
  return true;
}

/// Residuals of a column, in the order of its rows.
void FoilFilmSystem::Workspace::read_column(int k, const FoilFilmResidual& residual, Eigen::Ref<Vector> values) const {
  const FilmMesh& mesh = foil.mesh;
  const int n = mesh.unknown_rows();
  if (k > 0 && k < mesh.columns) {
    values.head(n) = residual.film.col(k).head(n) / (mesh.dtheta * mesh.dzeta);
  } else {
    values.head(n).setZero();
  }
  values[n] = residual.balance[k];
  values[n + 1] = residual.compatibility[k];
}

const Matrix& FoilFilmSystem::condense(const FoilFilmResidual& residual) {
  Workspace& w = *workspace_;
  for (std::size_t i = 0; i < w.columns.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    Workspace::Span& span = w.spans[i];
    for (int c = 0; c < span.columns->columns(); ++c) w.read_column(span.first + c, residual, span.right.col(c));
    span.right *= -1.0;
    span.columns->condense(span.right, span.before, span.after);
    w.read_column(w.columns[i], residual, w.condensed.col(at));
    w.condensed.col(at) -= span.after;
    if (i > 0) w.condensed.col(at - 1) -= span.before;
  }
  return w.condensed;
}

void FoilFilmSystem::expand(const Matrix& support_step, FoilFilmState& step) {
  Workspace& w = *workspace_;
  const FilmMesh& mesh = w.foil.mesh;
  const int n = mesh.unknown_rows();
  step.pressure.setZero(mesh.rows + 1, mesh.nodes());
  step.lift.setZero(mesh.nodes());
  step.moment.setZero(mesh.nodes());
  const auto set_column = [&](int k, const auto& values) {
    step.pressure.col(k).head(n) = values.head(n);
    step.lift[k] = values[n];
    step.moment[k] = values[n + 1];
  };
  for (std::size_t i = 0; i < w.columns.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    Workspace::Span& span = w.spans[i];
    span.after = support_step.col(at);
    set_column(w.columns[i], span.after);
    if (i > 0) span.before = support_step.col(at - 1);
    span.columns->expand(span.before, span.after, span.solution);
    for (int c = 0; c < span.columns->columns(); ++c) set_column(span.first + c, span.solution.col(c));
  }
  step.thickness = step.lift.transpose().replicate(mesh.rows + 1, 1);
}

}  // namespace bumpfoil
