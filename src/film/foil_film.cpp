#include "bumpfoil/film/foil_film.hpp"

#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "core/linear_algebra.hpp"
#include "film/foil_columns.hpp"
#include "film/foil_span.hpp"

namespace bumpfoil {

FoilFilm make_foil_film(const FilmMesh& mesh, const FilmScales& scales, double bending_stiffness, double pitch,
                        std::vector<int> supports, const Forming& forming, const FoilSheet& sheet) {
  BUMPFOIL_ASSERT(!mesh.closed && !supports.empty());
  FoilFilm foil;
  foil.mesh = mesh;
  const TopFoilBeam beam{
      .radius = scales.radius, .bending_stiffness = bending_stiffness, .theta = mesh.angles().tail(mesh.columns)};
  foil.top_foil = make_top_foil_moments(beam);
  foil.forming = pitch / scales.thickness * forming_rotations(beam, forming);
  foil.pitch = pitch;
  foil.stiffness = bending_stiffness / (pitch * pitch * pitch);
  foil.load_scale = mesh.copies() * scales.force() * mesh.dtheta * mesh.dzeta / (scales.thickness * foil.stiffness);
  foil.supports = std::move(supports);
  foil.lines = make_width_lines(sheet.modes, mesh.width);
  foil.stretching = foil.lines.to_stretching_modes();
  foil.shapes.resize(mesh.rows + 1, foil.lines.count());
  for (int j = 0; j <= mesh.rows; ++j) foil.shapes.row(j) = foil.lines.shapes(mesh.zeta(j));
  if (foil.stretching.rows() > 0) {
    const double R = scales.radius / pitch;
    const Membrane membrane = make_membrane(foil.lines.stretching_orders(), mesh.half_width() * R, R,
                                            sheet.stretching / foil.stiffness, sheet.poisson_ratio);
    foil.membrane = membrane_rows(membrane, R * mesh.dtheta * mesh.intervals);
  }
  return foil;
}

namespace {

/// Values of asperities at all nodes. @param value  (asperities, H) -> number
template <typename Value>
Matrix over_nodes(const FoilFilm& foil, const Matrix& thickness, Value&& value) {
  Matrix values = foil.mesh.field(0.0);
  if (!foil.asperities) return values;
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    for (Eigen::Index j = 0; j < values.rows(); ++j) {
      // One value serves all rows if H is uniform over the width.
      const bool known = j > 0 && thickness(j, k) == thickness(j - 1, k);
      values(j, k) = known ? values(j - 1, k) : value(*foil.asperities, thickness(j, k));
    }
  }
  return values;
}

}  // namespace

Matrix asperity_pressures(const FoilFilm& foil, const Matrix& thickness) {
  return over_nodes(foil, thickness, [](const Asperities& rough, double H) { return rough.pressure(H); });
}

Matrix asperity_balance(const FoilFilm& foil, const Matrix& pressures) {
  const FilmMesh& mesh = foil.mesh;
  if (!foil.asperities) return Matrix::Zero(foil.lines.count(), mesh.nodes());
  Matrix of_rows = -foil.load_scale * foil.shapes.transpose();
  for (int j = 0; j <= mesh.rows; ++j) of_rows.col(j) *= mesh.row_weight(j);
  Matrix balance = product(of_rows, pressures) * mesh.weights.asDiagonal();
  balance.col(0).setZero();  // the weld bears its own load
  return balance;
}

FoilFilmState undeformed(const FoilFilm& foil, const Matrix& thickness) {
  const Matrix of_lines = Matrix::Zero(foil.lines.count(), foil.mesh.nodes());
  return {{foil.mesh.field(1.0), thickness},
          of_lines,
          of_lines,
          Matrix::Zero(2 * foil.stretching.rows(), foil.mesh.nodes())};
}

namespace {

/// Balance and compatibility of one line, with `flexibility` times that of the whole width.
void line_residual(const FoilFilm& foil, Eigen::Index line, const FoilFilmState& state, FoilFilmResidual& residual) {
  const FilmMesh& mesh = foil.mesh;
  const auto U = state.deflection.row(line);
  const auto M = state.moment.row(line);
  const auto N = foil.shapes.col(line);
  const double flexibility = 1.0 / foil.lines.weight[line];
  for (int k = 0; k < mesh.nodes(); ++k) {
    const FoilColumn column(foil, k);
    const double U_before = k > 0 ? U[k - 1] : 0.0;
    const double M_before = k > 0 ? M[k - 1] : 0.0;
    double& balance = residual.balance(line, k);
    if (k > 0) {
      double excess = 0.0;
      for (int j = 0; j <= mesh.rows; ++j) excess += mesh.row_weight(j) * N[j] * (state.pressure(j, k) - 1.0);
      balance = column.kink_before * (M_before - M[k]) + column.arc * M[k] - column.load * excess;
    }
    if (k == mesh.columns) continue;
    // Differences first: U is smooth if the foil is soft, and only its curvature matters.
    if (k > 0) balance += column.kink_after * (M[k + 1] - M[k]);
    residual.compatibility(line, k) = column.kink_before * (U_before - U[k]) + column.kink_after * (U[k + 1] - U[k]) +
                                      column.arc * U[k] - flexibility * column.bend_before * M_before -
                                      flexibility * column.bend * M[k] - flexibility * column.bend_after * M[k + 1];
  }
}

/// Contribution of the membrane to the balances, and its own rows.
void membrane_residual(const FoilFilm& foil, const FoilFilmState& state, FoilFilmResidual& residual) {
  const Eigen::Index modes = foil.stretching.rows();
  const Matrix& unknowns = state.membrane;
  for (int k = 0; k < std::ssize(foil.membrane); ++k) {
    const MembraneRows& rows = foil.membrane[static_cast<std::size_t>(k)];
    auto own = residual.membrane.col(k);
    own = rows.own * unknowns.col(k) + rows.after * unknowns.col(k + 1);
    if (k == 0) continue;
    own += rows.before * unknowns.col(k - 1);
    own.head(modes) -= rows.length * foil.stretching * state.deflection.col(k);
    residual.balance.col(k) += rows.length * foil.stretching.transpose() * unknowns.col(k).head(modes);
  }
}

}  // namespace

void foil_residual(const FoilFilm& foil, const FoilFilmState& state, FoilFilmResidual& residual) {
  const int nodes = foil.mesh.nodes();
  residual.balance.setZero(foil.lines.count(), nodes);
  residual.compatibility.setZero(foil.lines.count(), nodes);
  residual.membrane.setZero(2 * foil.stretching.rows(), nodes);
  for (Eigen::Index line = 0; line < foil.lines.count(); ++line) line_residual(foil, line, state, residual);
  membrane_residual(foil, state, residual);
}

void foil_film_residual(const FoilFilm& foil, const ReynoldsEquation& equation, const FoilFilmState& state,
                        FoilFilmResidual& residual) {
  reynolds_residual(equation, state, residual.film);
  foil_residual(foil, state, residual);
  residual.compatibility.leftCols(foil.mesh.columns).rowwise() -= foil.forming.transpose();
  if (foil.asperities) {
    residual.balance += asperity_balance(foil, asperity_pressures(foil, state.thickness));
  }
}

struct FoilFilmSystem::Workspace {
  explicit Workspace(const FoilFilm& foil_film);

  template <typename Own>
  void assemble(int k, ColumnCoupling& before, Own&& own, ColumnCoupling& after) const;
  template <typename Own>
  void assemble_film(int k, ColumnCoupling& before, Own&& own, ColumnCoupling& after) const;
  template <typename Own>
  void assemble_line(int k, int line, ColumnCoupling& before, Own&& own, ColumnCoupling& after) const;
  template <typename Own>
  void assemble_asperities(int k, Own&& own) const;
  template <typename Own>
  void assemble_membrane(int k, ColumnCoupling& before, Own&& own, ColumnCoupling& after) const;
  void read_column(int k, const FoilFilmResidual& residual, Eigen::Ref<Vector> values) const;

  /// Columns between two blocks, or between the weld and the first block.
  struct Span {
    int first{};  ///< index of the first column
    std::unique_ptr<FoilSpan> columns;
    FoilSpan::Condensed condensed;
    Matrix right;  ///< negative residuals, column after column
    Matrix solution;
    Matrix before, after;  ///< right-hand sides in the equations of the neighbours
  };

  FoilFilm foil;
  int of_foil;  ///< foil unknowns per column
  int rows;     ///< all unknowns per column
  std::vector<Span> spans;
  std::vector<int> columns;                   ///< of the blocks
  std::vector<Block> lower, diagonal, upper;  ///< condensed
  ColumnCoupling nothing;                     ///< neighbour of the free end, without coupling
  FilmJacobian jacobian;
  Matrix asperity_slopes;
  Matrix film_residual;
  Matrix condensed;
};

FoilFilmSystem::Workspace::Workspace(const FoilFilm& foil_film)
    : foil(foil_film),
      of_foil(static_cast<int>(foil_film.unknowns())),
      rows(foil_film.mesh.unknown_rows() + of_foil),
      columns(foil_film.supports) {
  columns.push_back(foil.mesh.columns);
  int first = 0;
  for (const int column : columns) {
    const int length = column - first;
    BUMPFOIL_ASSERT(length >= (first > 0 ? 0 : 1));
    Span span;
    span.first = first;
    span.columns = make_foil_span(length, rows, of_foil, first > 0);
    spans.push_back(std::move(span));
    first = column + 1;
  }
  const Block zero = Block::Zero(rows, rows);
  lower.assign(columns.size(), zero);
  diagonal = upper = lower;
  nothing.resize(rows, of_foil);
}

/// Rows of column k: the film per cell area, balances, compatibilities, the membrane. The row of a prescribed unknown
/// sets its change to zero. Couplings that are always zero are not written.
template <typename Own>
void FoilFilmSystem::Workspace::assemble(int k, ColumnCoupling& before, Own&& own, ColumnCoupling& after) const {
  own.setZero();
  const int lines = static_cast<int>(foil.lines.count());
  if (k == 0 || k == foil.mesh.columns) {
    const int n = foil.mesh.unknown_rows();
    own.topLeftCorner(n, n).setIdentity();
    own.block(n, n, lines, lines).diagonal().setConstant(k == 0 ? 1.0 : 0.0);
    if (k > 0) own.bottomRightCorner(of_foil - lines, of_foil - lines).setIdentity();
  } else {
    assemble_film(k, before, own, after);
  }
  for (int line = 0; line < lines; ++line) assemble_line(k, line, before, own, after);
  if (foil.asperities && k > 0) assemble_asperities(k, own);
  if (k < std::ssize(foil.membrane)) assemble_membrane(k, before, own, after);
}

template <typename Own>
void FoilFilmSystem::Workspace::assemble_film(int k, ColumnCoupling& before, Own&& own, ColumnCoupling& after) const {
  const FilmMesh& mesh = foil.mesh;
  const int n = mesh.unknown_rows();
  const int first = mesh.first_unknown_row();
  const double per_area = 1.0 / (mesh.dtheta * mesh.dzeta);
  const FilmStencil& P = jacobian.by_pressure;
  const FilmStencil& H = jacobian.by_thickness;
  for (int i = 0; i < n; ++i) {
    const int j = first + i;
    const auto at = static_cast<std::size_t>(i);
    before.own[at] = P.before(j, k) * per_area;
    after.own[at] = P.after(j, k) * per_area;
    own(i, i) = P.own(j, k) * per_area;
    if (i > 0) own(i, i - 1) = P.inside(j, k) * per_area;
    if (i + 1 < n) own(i, i + 1) = P.outside(j, k) * per_area;
  }
  for (Eigen::Index line = 0; line < foil.lines.count(); ++line) {
    const auto N = foil.shapes.col(line);
    for (int i = 0; i < n; ++i) {
      const int j = first + i;
      before.by(line)[i] = H.before(j, k) * N[j] * per_area;
      after.by(line)[i] = H.after(j, k) * N[j] * per_area;
      const double inside = j > 0 ? H.inside(j, k) * N[j - 1] : 0.0;
      own(i, n + line) = (H.own(j, k) * N[j] + inside + H.outside(j, k) * N[j + 1]) * per_area;
    }
  }
}

/// Balance and compatibility of a line.
template <typename Own>
void FoilFilmSystem::Workspace::assemble_line(int k, int line, ColumnCoupling& before, Own&& own,
                                              ColumnCoupling& after) const {
  const FilmMesh& mesh = foil.mesh;
  const FoilColumn column(foil, k);
  const int lines = static_cast<int>(foil.lines.count());
  const int n = mesh.unknown_rows();
  const int by_U = line;
  const int by_M = lines + line;
  const int u = n + by_U;
  const int m = n + by_M;
  const bool weld = k == 0;
  const bool free_end = k == mesh.columns;
  if (!weld) {
    before.by(by_M)[u] = column.kink_before;
    if (!free_end) {
      for (int i = 0; i < n; ++i) {
        const int j = mesh.first_unknown_row() + i;
        own(u, i) = -column.load * mesh.row_weight(j) * foil.shapes(j, line);
      }
      own(u, m) = column.own();
      after.by(by_M)[u] = column.kink_after;
    }
  }
  if (!free_end) {
    const double flexibility = 1.0 / foil.lines.weight[line];
    before.by(by_U)[m] = column.kink_before;
    before.by(by_M)[m] = -flexibility * column.bend_before;
    if (!weld) own(m, u) = column.own();
    own(m, m) = -flexibility * column.bend;
    after.by(by_U)[m] = column.kink_after;
    after.by(by_M)[m] = -flexibility * column.bend_after;
  }
}

/// Contribution of asperities to the balances for a displacement of the foil: the derivative of asperity_balance().
template <typename Own>
void FoilFilmSystem::Workspace::assemble_asperities(int k, Own&& own) const {
  const FilmMesh& mesh = foil.mesh;
  const Eigen::Index lines = foil.lines.count();
  const Eigen::Index first = mesh.unknown_rows();
  for (int j = 0; j <= mesh.rows; ++j) {
    const double slope = foil.load_scale * mesh.column_weight(k) * mesh.row_weight(j) * asperity_slopes(j, k);
    for (Eigen::Index a = 0; a < lines; ++a) {
      for (Eigen::Index b = 0; b < lines; ++b)
        own(first + a, first + b) -= slope * foil.shapes(j, a) * foil.shapes(j, b);
    }
  }
}

/// The membrane rows, and its contribution to the balances.
template <typename Own>
void FoilFilmSystem::Workspace::assemble_membrane(int k, ColumnCoupling& before, Own&& own,
                                                  ColumnCoupling& after) const {
  const MembraneRows& membrane = foil.membrane[static_cast<std::size_t>(k)];
  const Eigen::Index n = foil.mesh.unknown_rows();
  const Eigen::Index lines = foil.lines.count();
  const Eigen::Index modes = foil.stretching.rows();
  const Eigen::Index first = n + 2 * lines;
  own.block(first, first, 2 * modes, 2 * modes) = membrane.own;
  for (Eigen::Index j = 0; j < 2 * modes; ++j) {
    for (Eigen::Index i = 0; i < 2 * modes; ++i) {
      before.by(2 * lines + j)[first + i] = membrane.before(i, j);
      after.by(2 * lines + j)[first + i] = membrane.after(i, j);
    }
  }
  if (k == 0) return;  // U = 0, and the weld bears the pressure of F
  own.block(n, first, lines, modes) = membrane.length * foil.stretching.transpose();
  own.block(first, n, modes, lines) = -membrane.length * foil.stretching;
}

FoilFilmSystem::FoilFilmSystem(const FoilFilm& foil) : workspace_(std::make_unique<Workspace>(foil)) {}
FoilFilmSystem::~FoilFilmSystem() = default;

const FilmJacobian& FoilFilmSystem::film_jacobian() const {
  return workspace_->jacobian;
}
const Matrix& FoilFilmSystem::asperity_slopes() const {
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

const Matrix& FoilFilmSystem::condensed() const {
  return workspace_->condensed;
}

bool FoilFilmSystem::linearise(const ReynoldsEquation& equation, const FoilFilmState& state) {
  Workspace& w = *workspace_;
  linearise_reynolds(equation, state, w.film_residual, w.jacobian);
  w.asperity_slopes =
      over_nodes(w.foil, state.thickness, [](const Asperities& rough, double H) { return rough.slope(H); });
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

/// Residuals of a column, in row order.
void FoilFilmSystem::Workspace::read_column(int k, const FoilFilmResidual& residual, Eigen::Ref<Vector> values) const {
  const FilmMesh& mesh = foil.mesh;
  const int n = mesh.unknown_rows();
  if (k > 0 && k < mesh.columns) {
    values.head(n) = residual.film.col(k).segment(mesh.first_unknown_row(), n) / (mesh.dtheta * mesh.dzeta);
  } else {
    values.head(n).setZero();
  }
  const Eigen::Index lines = foil.lines.count();
  values.segment(n, lines) = residual.balance.col(k);
  values.segment(n + lines, lines) = residual.compatibility.col(k);
  values.tail(residual.membrane.rows()) = residual.membrane.col(k);
}

void FoilFilmSystem::condense(std::span<const FoilFilmResidual> residuals) {
  Workspace& w = *workspace_;
  const auto sides = std::ssize(residuals);
  w.condensed.resize(w.rows, sides * blocks());
  for (std::size_t i = 0; i < w.columns.size(); ++i) {
    Workspace::Span& span = w.spans[i];
    const int length = span.columns->columns();
    span.right.resize(w.rows, sides * length);
    span.before.resize(w.rows, sides);
    span.after.resize(w.rows, sides);
    for (Eigen::Index s = 0; s < sides; ++s) {
      const FoilFilmResidual& residual = residuals[static_cast<std::size_t>(s)];
      for (int c = 0; c < length; ++c) w.read_column(span.first + c, residual, span.right.col(s * length + c));
      w.read_column(w.columns[i], residual, w.condensed.col(s * blocks() + static_cast<Eigen::Index>(i)));
    }
    span.right *= -1.0;
    span.columns->condense(span.right, span.before, span.after);
    for (Eigen::Index s = 0; s < sides; ++s) {
      const Eigen::Index at = s * blocks() + static_cast<Eigen::Index>(i);
      w.condensed.col(at) -= span.after.col(s);
      if (i > 0) w.condensed.col(at - 1) -= span.before.col(s);
    }
  }
}

void FoilFilmSystem::expand(const Matrix& support_steps, std::span<FoilFilmState> steps) {
  Workspace& w = *workspace_;
  const FilmMesh& mesh = w.foil.mesh;
  const int n = mesh.unknown_rows();
  const Eigen::Index lines = w.foil.lines.count();
  const Eigen::Index of_membrane = 2 * w.foil.stretching.rows();
  for (FoilFilmState& step : steps) {
    step.pressure.setZero(mesh.rows + 1, mesh.nodes());
    step.deflection.setZero(lines, mesh.nodes());
    step.moment.setZero(lines, mesh.nodes());
    step.membrane.setZero(of_membrane, mesh.nodes());
  }
  const auto set_column = [&](std::size_t side, int k, const auto& values) {
    FoilFilmState& step = steps[side];
    step.pressure.col(k).segment(mesh.first_unknown_row(), n) = values.head(n);
    step.deflection.col(k) = values.segment(n, lines);
    step.moment.col(k) = values.segment(n + lines, lines);
    step.membrane.col(k) = values.tail(of_membrane);
  };
  for (std::size_t i = 0; i < w.columns.size(); ++i) {
    Workspace::Span& span = w.spans[i];
    const int length = span.columns->columns();
    for (std::size_t s = 0; s < steps.size(); ++s) {
      const auto side = static_cast<Eigen::Index>(s);
      const Eigen::Index at = side * blocks() + static_cast<Eigen::Index>(i);
      span.after.col(side) = support_steps.col(at);
      set_column(s, w.columns[i], support_steps.col(at));
      if (i > 0) span.before.col(side) = support_steps.col(at - 1);
    }
    span.columns->expand(span.before, span.after, span.solution);
    for (std::size_t s = 0; s < steps.size(); ++s) {
      for (int c = 0; c < length; ++c) {
        set_column(s, span.first + c, span.solution.col(static_cast<Eigen::Index>(s) * length + c));
      }
    }
  }
  for (FoilFilmState& step : steps) step.thickness = w.foil.shapes * step.deflection;
}

}  // namespace bumpfoil
