#include "bumpfoil/film/foil_film.hpp"

#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "film/column_chain.hpp"
#include "film/foil_columns.hpp"

namespace bumpfoil {

FoilFilm make_foil_film(const FilmMesh& mesh, const FilmScales& scales, double bending_stiffness, double pitch,
                        std::vector<int> supports) {
  BUMPFOIL_ASSERT(!mesh.closed && !supports.empty());
  FoilFilm foil;
  foil.mesh = mesh;
  foil.top_foil = make_top_foil_moments(
      {.radius = scales.radius, .bending_stiffness = bending_stiffness, .theta = mesh.angles().tail(mesh.columns)});
  foil.pitch = pitch;
  foil.stiffness = bending_stiffness / (pitch * pitch * pitch);
  foil.load_scale = 2.0 * scales.force() * mesh.dtheta * mesh.dzeta / (scales.thickness * foil.stiffness);
  foil.supports = std::move(supports);
  return foil;
}

FoilFilmState undeformed(const FoilFilm& foil, const Matrix& thickness) {
  return {.film = {foil.mesh.field(1.0), thickness},
          .lift = Vector::Zero(foil.mesh.nodes()),
          .moment = Vector::Zero(foil.mesh.nodes())};
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
      for (int j = 0; j <= mesh.rows; ++j) excess += mesh.row_weight(j) * (state.film.pressure(j, k) - 1.0);
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
  reynolds_residual(equation, state.film, residual.film);
  foil_residual(foil, state, residual);
}

struct FoilFilmSystem::Workspace {
  explicit Workspace(const FoilFilm& foil_film);

  void assemble(int k, ColumnChain::Block before, ColumnChain::Block own, ColumnChain::Block after);
  void read_column(int k, const FoilFilmResidual& residual, Eigen::Ref<Vector> values) const;

  /// Columns between two blocks, or between the weld and the first.
  struct Span {
    int first{};  ///< column
    std::unique_ptr<ColumnChain> chain;
    ColumnChain::Response to_before, to_after;
    Vector right;     ///< minus the residuals
    Vector solution;  ///< with both neighbours held, then with them as they are
  };

  FoilFilm foil;
  int rows;  ///< unknowns of a column
  std::vector<Span> spans;
  std::vector<int> columns;                        ///< of the blocks
  std::vector<Block> lower, diagonal, upper;       ///< condensed
  std::vector<std::pair<Block, Block>> couplings;  ///< before and after, of every block
  FilmJacobian jacobian;
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
    span.chain = make_column_chain(length, rows);
    span.right.resize(Eigen::Index{length} * rows);
    spans.push_back(std::move(span));
    first = column + 1;
  }
  const Block zero = Block::Zero(rows, rows);
  lower.assign(columns.size(), zero);
  diagonal = upper = lower;
  couplings.assign(columns.size(), {zero, zero});
  condensed.resize(rows, static_cast<Eigen::Index>(columns.size()));
}

/// Rows of column k: the film per area of a cell, balance, compatibility. Where an unknown is given, its own row says
/// that it does not move.
void FoilFilmSystem::Workspace::assemble(int k, ColumnChain::Block to_before, ColumnChain::Block to_own,
                                         ColumnChain::Block to_after) {
  const FilmMesh& mesh = foil.mesh;
  const int n = mesh.unknown_rows();
  const int u = n;
  const int m = n + 1;
  to_before.setZero();
  to_own.setZero();
  to_after.setZero();
  const bool weld = k == 0;
  const bool free_end = k == mesh.columns;
  if (weld || free_end) {
    for (int j = 0; j < n; ++j) to_own(j, j) = 1.0;
    to_own(weld ? u : m, weld ? u : m) = 1.0;
  } else {
    const double area = mesh.dtheta * mesh.dzeta;
    const FilmStencil& P = jacobian.by_pressure;
    const FilmStencil& H = jacobian.by_thickness;
    for (int j = 0; j < n; ++j) {
      to_before(j, j) = P.before(j, k) / area;
      to_before(j, u) = H.before(j, k) / area;
      to_own(j, j) = P.own(j, k) / area;
      if (j > 0) to_own(j, j - 1) = P.inside(j, k) / area;
      if (j + 1 < n) to_own(j, j + 1) = P.outside(j, k) / area;
      to_own(j, u) = (H.own(j, k) + H.inside(j, k) + H.outside(j, k)) / area;
      to_after(j, j) = P.after(j, k) / area;
      to_after(j, u) = H.after(j, k) / area;
    }
  }
  const FoilColumn column(foil, k);
  if (!weld) {
    to_before(u, m) = column.kink_before;
    if (!free_end) {
      for (int j = 0; j < n; ++j) to_own(u, j) = -column.load * mesh.row_weight(j);
      to_own(u, m) = column.own();
      to_after(u, m) = column.kink_after;
    }
  }
  if (!free_end) {
    to_before(m, u) = column.kink_before;
    to_before(m, m) = -column.bend_before;
    if (!weld) to_own(m, u) = column.own();
    to_own(m, m) = -column.bend;
    to_after(m, u) = column.kink_after;
    to_after(m, m) = -column.bend_after;
  }
}

FoilFilmSystem::FoilFilmSystem(const FoilFilm& foil) : workspace_(std::make_unique<Workspace>(foil)) {}
FoilFilmSystem::~FoilFilmSystem() = default;

const FilmJacobian& FoilFilmSystem::film_jacobian() const {
  return workspace_->jacobian;
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
  linearise_reynolds(equation, state.film, w.film_residual, w.jacobian);
  for (Workspace::Span& span : w.spans) {
    ColumnChain& chain = *span.chain;
    for (int i = 0; i < chain.columns(); ++i) {
      w.assemble(span.first + i, chain.lower(i), chain.diagonal(i), chain.upper(i));
    }
    if (!chain.factor()) return false;
    chain.respond(span.to_before, span.to_after);
  }
  const auto map = [](Block& block) { return ColumnChain::Block(block.data(), block.rows(), block.cols()); };
  for (std::size_t i = 0; i < w.columns.size(); ++i) {
    auto& [before, after] = w.couplings[i];
    Block& own = w.diagonal[i];
    w.assemble(w.columns[i], map(before), map(own), map(after));
    own.noalias() -= before * w.spans[i].to_after.last;
    w.lower[i].noalias() = -before * w.spans[i].to_before.last;
    if (i + 1 == w.columns.size()) continue;
    own.noalias() -= after * w.spans[i + 1].to_before.first;
    w.upper[i].noalias() = -after * w.spans[i + 1].to_after.first;
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
  for (Workspace::Span& span : w.spans) {
    for (int i = 0; i < span.chain->columns(); ++i) {
      w.read_column(span.first + i, residual, span.right.segment(Eigen::Index{i} * w.rows, w.rows));
    }
    span.right *= -1.0;
    span.solution = span.right;
    span.chain->solve_in_place(span.solution);
  }
  for (std::size_t i = 0; i < w.columns.size(); ++i) {
    const auto& [before, after] = w.couplings[i];
    auto column = w.condensed.col(static_cast<Eigen::Index>(i));
    w.read_column(w.columns[i], residual, column);
    column.noalias() += before * w.spans[i].solution.tail(w.rows);
    if (i + 1 < w.columns.size()) column.noalias() += after * w.spans[i + 1].solution.head(w.rows);
  }
  return w.condensed;
}

void FoilFilmSystem::expand(const Matrix& support_step, FoilFilmState& step) {
  Workspace& w = *workspace_;
  const FilmMesh& mesh = w.foil.mesh;
  const int n = mesh.unknown_rows();
  step.film.pressure.setZero(mesh.rows + 1, mesh.nodes());
  step.lift.setZero(mesh.nodes());
  step.moment.setZero(mesh.nodes());
  const auto set_column = [&](int k, const auto& values) {
    step.film.pressure.col(k).head(n) = values.head(n);
    step.lift[k] = values[n];
    step.moment[k] = values[n + 1];
  };
  for (std::size_t i = 0; i < w.columns.size(); ++i) {
    const auto own = support_step.col(static_cast<Eigen::Index>(i));
    set_column(w.columns[i], own);
    Workspace::Span& span = w.spans[i];
    span.solution = span.right;
    if (i > 0) {
      span.solution.head(w.rows).noalias() -= span.chain->lower(0) * support_step.col(static_cast<Eigen::Index>(i) - 1);
    }
    span.solution.tail(w.rows).noalias() -= span.chain->upper(span.chain->columns() - 1) * own;
    span.chain->solve_in_place(span.solution);
    for (int c = 0; c < span.chain->columns(); ++c) {
      set_column(span.first + c, span.solution.segment(Eigen::Index{c} * w.rows, w.rows));
    }
  }
  step.film.thickness = step.lift.transpose().replicate(mesh.rows + 1, 1);
}

}  // namespace bumpfoil
