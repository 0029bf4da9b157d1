#include "support/bonded_foils.hpp"

#include <cstddef>
#include <vector>

#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Indices of all dimensionless unknowns in one vector: those of the top foil column by column, then those of K. A
/// crest shares that of the top foil over it.
class BondedUnknowns {
 public:
  explicit BondedUnknowns(const BearingModel& bearing)
      : foil_(bearing.film->pads.front().foil), of_top_foil_(foil_.unknowns() * foil_.mesh.nodes()) {
    const BumpDofs& dofs = bearing.structure.dofs;
    const BlockTridiagonal& K = bearing.problem.K;
    of_bumps_.assign(static_cast<std::size_t>(K.rows()), -1);
    for (int b = 0; b < bearing.structure.K.blocks(); ++b) {
      const Eigen::Index first = Eigen::Index{bearing.block(b)} * K.block_size();
      const Matrix& block = K.diagonal[static_cast<std::size_t>(bearing.block(b))];
      for (Eigen::Index i = 0; i < block.rows(); ++i) {
        const Eigen::Index row = first + i;
        if (block(i, i) != 0.0) of_bumps_[static_cast<std::size_t>(row)] = of_top_foil_ + row;
      }
      for (Eigen::Index s = 0; s < foil_.lines.count(); ++s) {
        const int bump = b - bearing.structure.first_bump;
        if (bump >= 0) of_bumps_[static_cast<std::size_t>(first + bearing.place(s, dofs.crest_v))] = crest(s, bump);
      }
    }
  }

  [[nodiscard]] Eigen::Index count() const { return of_top_foil_ + std::ssize(of_bumps_); }
  [[nodiscard]] Eigen::Index deflection(Eigen::Index line, int column) const {
    return foil_.unknowns() * column + line;
  }
  [[nodiscard]] Eigen::Index moment(Eigen::Index line, int column) const {
    return deflection(line, column) + foil_.lines.count();
  }
  [[nodiscard]] Eigen::Index membrane(Eigen::Index row, int column) const {
    return deflection(row, column) + 2 * foil_.lines.count();
  }
  [[nodiscard]] Eigen::Index crest(Eigen::Index line, int bump) const {
    return deflection(line, foil_.supports[static_cast<std::size_t>(bump)]);
  }
  /// Index of an unknown of K; -1 if it is unused.
  [[nodiscard]] Eigen::Index of_bumps(Eigen::Index row) const { return of_bumps_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] Eigen::Index behind_top_foil() const { return of_top_foil_; }

 private:
  const FoilFilm& foil_;
  Eigen::Index of_top_foil_;
  std::vector<Eigen::Index> of_bumps_;
};

/// The residuals of the top foil, each at the index of its unknown.
Vector residuals(const FoilFilm& foil, const BondedUnknowns& at, const Vector& unknowns, const Matrix& pressure) {
  FoilFilmState state = undeformed(foil, foil.mesh.field(1.0));
  state.pressure = pressure;
  FoilFilmResidual residual;
  Vector found = Vector::Zero(unknowns.size());
  const auto each = [&](auto&& visit) {
    for (int k = 0; k < foil.mesh.nodes(); ++k) {
      for (Eigen::Index s = 0; s < foil.lines.count(); ++s) {
        visit(at.deflection(s, k), state.deflection(s, k), residual.balance, s, k);
        visit(at.moment(s, k), state.moment(s, k), residual.compatibility, s, k);
      }
      for (Eigen::Index i = 0; i < state.membrane.rows(); ++i) {
        visit(at.membrane(i, k), state.membrane(i, k), residual.membrane, i, k);
      }
    }
  };
  each([&](Eigen::Index place, double& value, Matrix&, Eigen::Index, int) { value = unknowns[place]; });
  foil_residual(foil, state, residual);
  each([&](Eigen::Index place, double&, Matrix& rows, Eigen::Index i, int k) { found[place] = rows(i, k); });
  return found;
}

}  // namespace

BondedAnswer bonded_answer(const BearingModel& bearing, const BondedLoading& loading) {
  const FoilFilm& foil = bearing.film->pads.front().foil;
  const FilmMesh& mesh = foil.mesh;
  const double unit = bearing.film->scales.thickness;
  const BondedUnknowns at(bearing);
  const Vector nothing = Vector::Zero(at.count());
  const Vector load = residuals(foil, at, nothing, loading.pressure);
  Matrix A = Matrix::Zero(at.count(), at.count());
  for (Eigen::Index i = 0; i < at.behind_top_foil(); ++i) {
    A.col(i) = residuals(foil, at, Vector::Unit(at.count(), i), mesh.field(1.0));
  }
  const Matrix K = bearing.problem.K.dense() / foil.stiffness;
  for (Eigen::Index i = 0; i < K.rows(); ++i) {
    for (Eigen::Index j = 0; j < K.cols(); ++j) {
      if (at.of_bumps(i) >= 0 && at.of_bumps(j) >= 0) A(at.of_bumps(i), at.of_bumps(j)) += K(i, j);
    }
  }

  // Marks the prescribed unknowns.
  std::vector<bool> given(static_cast<std::size_t>(at.count()), false);
  const auto give = [&](Eigen::Index place) { given[static_cast<std::size_t>(place)] = true; };
  Vector z = nothing;
  for (Eigen::Index place = at.behind_top_foil(); place < at.count(); ++place) {
    if (at.of_bumps(place - at.behind_top_foil()) != place) give(place);  // a crest, or unused
  }
  for (Eigen::Index s = 0; s < foil.lines.count(); ++s) {
    give(at.deflection(s, 0));
    give(at.moment(s, mesh.columns));
    for (int bump = 0; loading.crest_lift && bump < bearing.bumps(); ++bump) {
      give(at.crest(s, bump));
      z[at.crest(s, bump)] = (*loading.crest_lift)(s, bump) / unit;
    }
    const BumpDofs& dofs = bearing.structure.dofs;
    for (int b = 0; b < bearing.structure.K.blocks(); ++b) {
      const auto hold = [&](int unknown) {
        give(at.of_bumps(Eigen::Index{bearing.block(b)} * bearing.problem.K.block_size() + bearing.place(s, unknown)));
      };
      for (const int foot : dofs.foot_v) hold(foot);
      if (loading.feet_slide) continue;
      for (const int foot : dofs.foot_u) hold(foot);
    }
  }
  for (Eigen::Index i = 0; i < 2 * foil.stretching.rows(); ++i) give(at.membrane(i, mesh.columns));

  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < at.count(); ++i) {
    if (!given[static_cast<std::size_t>(i)]) free.push_back(i);
  }
  const Vector right = -(load + A * z)(free);
  const Vector found = solve(A(free, free), right);
  z(free) = found;
  const Vector held = load + A * z;
  BondedAnswer answer{Matrix(foil.lines.count(), mesh.nodes()), Matrix(foil.lines.count(), bearing.bumps())};
  for (Eigen::Index s = 0; s < foil.lines.count(); ++s) {
    for (int k = 0; k < mesh.nodes(); ++k) answer.deflection(s, k) = unit * z[at.deflection(s, k)];
    for (int bump = 0; bump < bearing.bumps(); ++bump) {
      answer.crest_force(s, bump) = foil.stiffness * unit * held[at.crest(s, bump)];
    }
  }
  return answer;
}

}  // namespace bumpfoil
