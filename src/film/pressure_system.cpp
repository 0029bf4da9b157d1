#include "film/pressure_system.hpp"

#include <cmath>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// First column of the chain: column 0 is an open edge, or borders a closed film.
constexpr int first_in_chain = 1;

/// Derivatives of the equations of column k by the pressures of a column, itself or a neighbour: directly, and via the
/// thickness there.
/// @param by_pressure, by_thickness  stencil columns of this pair of columns
template <typename Target, typename Pressures, typename Thicknesses>
void fill_coupling(const FilmMesh& mesh, const Foundation& foundation, const Pressures& by_pressure,
                   const Thicknesses& by_thickness, Target&& block) {
  const int n = mesh.unknown_rows();
  const int first = mesh.first_unknown_row();
  for (int j = 0; j < n; ++j) block(j, j) += by_pressure[first + j];
  if (foundation.kind == FoundationKind::pointwise) {
    for (int j = 0; j < n; ++j) block(j, j) += foundation.compliance * by_thickness[first + j];
  }
  if (foundation.kind == FoundationKind::axial_mean) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        block(j, i) += foundation.compliance * mesh.row_weight(first + i) / mesh.rows * by_thickness[first + j];
      }
    }
  }
}

/// The same for a column and itself, which includes coupling of neighbouring rows.
template <typename Target>
void fill_own(const FilmMesh& mesh, const FilmJacobian& jacobian, const Foundation& foundation, int k, Target&& block) {
  const FilmStencil& P = jacobian.by_pressure;
  const FilmStencil& H = jacobian.by_thickness;
  const int n = mesh.unknown_rows();
  const int first = mesh.first_unknown_row();
  const double local = foundation.kind == FoundationKind::pointwise ? foundation.compliance : 0.0;
  for (int j = 0; j < n; ++j) {
    const int row = first + j;
    if (j > 0) block(j, j - 1) += P.inside(row, k) + local * H.inside(row, k);
    if (j + 1 < n) block(j, j + 1) += P.outside(row, k) + local * H.outside(row, k);
  }
  if (foundation.kind == FoundationKind::axial_mean) {
    fill_coupling(mesh, foundation, P.own.col(k), H.own.col(k) + H.inside.col(k) + H.outside.col(k), block);
  } else {
    fill_coupling(mesh, foundation, P.own.col(k), H.own.col(k), block);
  }
}

}  // namespace

PressureSystem::PressureSystem(const FilmMesh& mesh)
    : mesh_(mesh),
      chain_(make_column_chain(mesh.columns - 1, mesh.unknown_rows())),
      border_(1, mesh.unknown_rows()),
      right_(Eigen::Index{mesh.columns - 1} * mesh.unknown_rows()) {}

void PressureSystem::assemble(const FilmJacobian& jacobian, const Foundation& foundation) {
  const FilmStencil& P = jacobian.by_pressure;
  const FilmStencil& H = jacobian.by_thickness;
  const auto fill = [&](int k, auto&& before, auto&& own, auto&& after) {
    before.setZero();
    own.setZero();
    after.setZero();
    fill_coupling(mesh_, foundation, P.before.col(k), H.before.col(k), before);
    fill_own(mesh_, jacobian, foundation, k, own);
    fill_coupling(mesh_, foundation, P.after.col(k), H.after.col(k), after);
  };
  for (int i = 0; i < chain_->columns(); ++i)
    fill(first_in_chain + i, chain_->lower(i), chain_->diagonal(i), chain_->upper(i));
  if (!mesh_.closed) return;
  const int n = mesh_.unknown_rows();
  for (auto* part : {&border_before_, &border_own_, &border_after_}) part->resize(n, n);
  fill(0, border_before_, border_own_, border_after_);
}

bool PressureSystem::factor() {
  if (!chain_->factor()) return false;
  if (!mesh_.closed) return true;
  chain_->respond(to_before_, to_after_);
  auto& border = border_.diagonal(0);
  border = border_own_;
  border -= product(border_after_, to_before_.first + to_after_.first);
  border -= product(border_before_, to_before_.last + to_after_.last);
  return border_.factor();
}

/// The step of column 0, from the residual of its equations after the chain is solved with it held.
void PressureSystem::read_border_step(const Matrix& residual) {
  const int n = mesh_.unknown_rows();
  border_step_ = -residual.col(0).segment(mesh_.first_unknown_row(), n) - border_after_ * right_.head(n) -
                 border_before_ * right_.tail(n);
  border_.solve_in_place(border_step_);
}

void PressureSystem::solve(const Matrix& residual, Matrix& step) {
  const int n = mesh_.unknown_rows();
  const int first = mesh_.first_unknown_row();
  const int columns = chain_->columns();
  const auto set_right = [&] {
    for (int i = 0; i < columns; ++i)
      right_.segment(Eigen::Index{i} * n, n) = -residual.col(first_in_chain + i).segment(first, n);
  };
  set_right();
  chain_->solve_in_place(right_);
  if (mesh_.closed) {
    read_border_step(residual);
    set_right();
    right_.head(n) -= chain_->lower(0) * border_step_;
    right_.tail(n) -= chain_->upper(columns - 1) * border_step_;
    chain_->solve_in_place(right_);
    step.col(0).segment(first, n) = border_step_;
  }
  for (int i = 0; i < columns; ++i) {
    step.col(first_in_chain + i).segment(first, n) = right_.segment(Eigen::Index{i} * n, n);
  }
}

}  // namespace bumpfoil
