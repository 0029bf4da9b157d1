#include "alternating.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/film/film_solver.hpp"

namespace bumpfoil {
namespace {

using Places = std::vector<Eigen::Index>;

/// Top foil and bump foil under given loads. Contacts act on the bump foil and the columns over its crests; the rest of
/// the top foil is eliminated.
class PressedFoils {
 public:
  explicit PressedFoils(const BearingModel& bearing);

  [[nodiscard]] const ContactProblem& problem() const { return problem_; }

  /// Loads (N) on the columns after the weld, condensed to the contacts.
  [[nodiscard]] Vector condensed(const Vector& loads) const {
    const Vector all = padded(loads);
    return all(kept_) - coupling_.transpose() * hidden_lu_.solve(all(hidden_));
  }

  /// Displacements (m) of the columns under these loads, from those at the contacts.
  [[nodiscard]] Vector displacements(const Vector& loads, const Vector& seen) const {
    Vector x = padded(loads);
    x(hidden_) = hidden_lu_.solve(x(hidden_) - coupling_ * seen).eval();
    x(kept_) = seen;
    return x.head(columns_);
  }

 private:
  [[nodiscard]] Vector padded(const Vector& loads) const {
    Vector all = Vector::Zero(size_);
    all.head(columns_) = loads;
    return all;
  }
  [[nodiscard]] Matrix whole_matrix(const BearingModel& bearing);

  Eigen::Index columns_;  ///< after the weld
  Eigen::Index size_{};   ///< of displacements and moments of the top foil by columns, and the bump foil
  Places kept_, hidden_;  ///< indices among them
  Matrix coupling_;       ///< of hidden to kept unknowns
  Eigen::PartialPivLU<Matrix> hidden_lu_;
  ContactProblem problem_;
};

/// For displacements u and moments M: D M are loads, D' u - T M = 0. Moments are scaled to lengths.
void add_top_foil(const BearingModel& bearing, Eigen::Index columns, Matrix& K) {
  const TopFoilMoments& form = bearing.film->pads.front().foil.top_foil;
  const double unit = bearing.film->pads.front().foil.stiffness * bearing.film->pads.front().foil.pitch;  // N
  for (Eigen::Index k = 0; k < columns; ++k) {
    const Vector loads = unit * loads_of_moments(form, Vector::Unit(columns, k));
    K.block(0, columns + k, columns, 1) = loads;
    K.block(columns + k, 0, 1, columns) = loads.transpose();
    K(columns + k, columns + k) = -unit * unit * form.compliance_diagonal[k];
    if (k + 1 == columns) continue;
    const double off = -unit * unit * form.compliance_off[k];
    K(columns + k, columns + k + 1) = K(columns + k + 1, columns + k) = off;
  }
}

PressedFoils::PressedFoils(const BearingModel& bearing) : columns_(bearing.film->pads.front().foil.top_foil.size()) {
  const Matrix K = whole_matrix(bearing);
  coupling_ = K(hidden_, kept_);
  hidden_lu_.compute(K(hidden_, hidden_));
  problem_.K = BlockTridiagonal(1, static_cast<int>(kept_.size()));
  problem_.K.diagonal.front() = K(kept_, kept_) - coupling_.transpose() * hidden_lu_.solve(coupling_);
  problem_.force_scale = bearing.problem.force_scale;
  const auto seen_at = [&](Eigen::Index place) {
    return static_cast<int>(std::find(kept_.begin(), kept_.end(), place) - kept_.begin());
  };
  const int size = bearing.problem.K.block_size();
  for (std::size_t b = 0; b < bearing.film->pads.front().foil.supports.size(); ++b) {
    const auto moved = [&](int place) {
      if (place < 0) return -1;
      if (place == bearing.structure.dofs.top_u) return seen_at(bearing.film->pads.front().foil.supports[b] - 1);
      return seen_at(2 * columns_ + static_cast<Eigen::Index>(b) * size + place);
    };
    for (const ContactSite& site : bearing.problem.sites) {
      if (site.block != static_cast<int>(b)) continue;
      problem_.sites.push_back({.plus = moved(site.plus),
                                .minus = moved(site.minus),
                                .tangential = moved(site.tangential),
                                .friction_coefficient = site.friction_coefficient});
    }
  }
}

/// Also sorts the unknowns. The blocks of the bump foil follow the top foil unchanged; their unused unknowns are
/// neither kept nor hidden, and stay zero.
Matrix PressedFoils::whole_matrix(const BearingModel& bearing) {
  const BumpDofs& dofs = bearing.structure.dofs;
  const Matrix foil = bearing.problem.K.dense();
  const Eigen::Index first = 2 * columns_;
  size_ = first + foil.rows();
  Matrix K = Matrix::Zero(size_, size_);
  add_top_foil(bearing, columns_, K);
  K.bottomRightCorner(foil.rows(), foil.rows()) = foil;
  const std::vector<int>& supports = bearing.film->pads.front().foil.supports;
  for (Eigen::Index i = 0; i < first; ++i) {
    const bool crest = std::find(supports.begin(), supports.end(), i + 1) != supports.end();
    (crest ? kept_ : hidden_).push_back(i);
  }
  for (std::size_t b = 0; b < supports.size(); ++b) {
    for (int i = 0; i < dofs.size; ++i) {
      if (i == dofs.top_u || i == dofs.top_moment) continue;
      kept_.push_back(first + static_cast<Eigen::Index>(b) * bearing.problem.K.block_size() + i);
    }
  }
  return K;
}

/// Outward loads on the columns after the weld, N.
Vector loads_of(const BearingModel& bearing, const Matrix& pressure) {
  const FilmMesh& mesh = bearing.film->pads.front().foil.mesh;
  Vector loads(mesh.columns);
  for (int k = 1; k <= mesh.columns; ++k) {
    double excess = 0.0;
    for (int j = 0; j <= mesh.rows; ++j) excess += mesh.row_weight(j) * (pressure(j, k) - 1.0);
    loads[k - 1] = 2.0 * bearing.film->scales.force() * mesh.dtheta * mesh.dzeta * mesh.column_weight(k) * excess;
  }
  return loads;
}

}  // namespace

AlternatingReport alternate(const BearingModel& bearing, const Eigen::Vector2d& position, double speed,
                            const AlternatingOptions& options, BearingState& state) {
  using End = AlternatingReport::End;
  const PressedFoils foils(bearing);
  const ContactProblem& problem = foils.problem();
  NewtonSolver contacts(problem);
  FilmSolver films(bearing.film->pads.front().foil.mesh, {});
  const ReynoldsEquation equation = film_equation(*bearing.film, bearing.film->pads.front(), speed);
  const Matrix undeformed = undeformed_thickness(bearing, position);
  ContactLoading loading{.initial_gap = bearing.assembled_gap.head(problem.contacts()), .load = {}};
  const ContactState unstressed = ContactState::unstressed(problem);
  ContactState pressed = unstressed;
  Matrix H = undeformed;
  H.rowwise() += state.film.deflection.row(0);
  AlternatingReport report;
  while (report.end == End::spent && report.iterations < options.most) {
    ++report.iterations;
    const Status film = films.solve(equation, H, state.film).status;
    if (film != Status::converged) {
      report.end = film == Status::no_room ? End::no_room : End::no_film;
      break;
    }
    const Vector loads = loads_of(bearing, state.film.pressure);
    loading.load = foils.condensed(loads);
    if (!contacts.solve(loading, unstressed, pressed).converged()) {
      report.end = End::no_contact;
      break;
    }
    Vector step = -state.film.deflection.row(0).transpose();
    step.tail(loads.size()) += foils.displacements(loads, pressed.x) / bearing.film->scales.thickness;
    report.change = step.cwiseAbs().maxCoeff();
    state.film.deflection.row(0) += options.relaxation * step.transpose();
    H = undeformed;
    H.rowwise() += state.film.deflection.row(0);
    if (report.change < options.tolerance) report.end = End::converged;
  }
  return report;
}

}  // namespace bumpfoil
