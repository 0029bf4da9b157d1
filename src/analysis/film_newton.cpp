#include "analysis/film_newton.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/film_impedance.hpp"
#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {
namespace {

constexpr int max_halvings = 8;
/// Part of a step that is taken where no halving lets the residual fall.
constexpr double forced_fraction = 0.25;
/// Longest displacement of the journal in one step, in units of c. Where it is held, the state comes along on its
/// branch in steps this short; on the way to its load the residual sees to that.
constexpr double longest_displacement = 0.00625;
constexpr double longest_displacement_under_load = 0.15;
/// Residual of a journal that is not yet where it is held, per c. The film's residual grows with the square of a step,
/// and Newton's method takes it away in the next one: with a lesser weight it would keep steps far below the longest.
constexpr double weight_of_way = 30.0;
/// Displacements to a position that roundings have left, in units of c.
constexpr double rounded_displacement = 1e-14;

}  // namespace

FilmNewton::FilmNewton(const FilmBearing& bearing, const FilmSolverOptions& options)
    : bearing_(bearing),
      options_(options),
      system_(bearing.foil),
      modes_(make_mode_system(bearing.problem)),
      contacts_(bearing.problem, modes_),
      K_(bearing.problem.K),
      loading_(ContactLoading::none(bearing.problem)),
      begin_(ContactState::unstressed(bearing.problem)),
      support_step_(bearing.foil.mesh.rows + 2, system_.blocks()) {
  for (const Matrix& block : K_.upper) K_.lower.push_back(block.transpose());
  bump_K_ = K_;
}

template <typename Visitor>
void FilmNewton::for_each_place(int b, Visitor&& visit) const {
  const int n = bearing_.foil.mesh.rows;
  const int first_pressure = bearing_.dofs.size;
  if (b + 1 == system_.blocks()) {
    visit(first_pressure, n);  // the free end
    return;
  }
  for (int j = 0; j < n; ++j) visit(first_pressure + j, j);
  visit(bearing_.dofs.top_u, n);
  visit(bearing_.dofs.top_moment, n + 1);
}

/// Forces that the bump foil takes at its displacements, N; what is held in the last block takes none.
Vector& FilmNewton::find_bump_forces(const ContactState& state) {
  bump_forces_ = bump_K_.multiply(state.x);
  bump_forces_.tail(bump_K_.block_size()).setZero();
  return bump_forces_;
}

/// Residuals of film and foil without contact forces; returns the norm of all residuals, with them: the film per area
/// of a cell, forces by EI' c / p^3, compatibility by c / p, what is missing of the load by pa R^2, of the position by
/// c / weight_of_way.
double FilmNewton::find_residual(const OperatingPoint& to, const ReynoldsEquation& equation,
                                 const FilmBearingState& state) {
  const FilmMesh& mesh = bearing_.foil.mesh;
  foil_film_residual(bearing_.foil, equation, state.foil, residual_);
  double square =
      residual_.film.block(0, mesh.first_unknown(), mesh.unknown_rows(), mesh.unknown_columns()).squaredNorm() /
      (mesh.dtheta * mesh.dtheta * mesh.dzeta * mesh.dzeta);

  const ContactState& contact = state.contact;
  Vector& forces = find_bump_forces(contact);
  forces -= contact_forces(bearing_.problem, contact.normal_force, contact.friction_force);
  const double unit = bearing_.foil.stiffness * bearing_.scales.thickness;
  double balance = residual_.balance.squaredNorm();
  for (std::size_t i = 0; i < bearing_.foil.supports.size(); ++i) {
    const double held = residual_.balance[bearing_.foil.supports[i]];
    double& support = forces[static_cast<Eigen::Index>(i) * bump_K_.block_size() + bearing_.dofs.top_u];
    balance += (held + support / unit) * (held + support / unit) - held * held;
    support = 0.0;
  }
  square += balance + residual_.compatibility.squaredNorm() + forces.squaredNorm() / (unit * unit);
  if (to.control == OperatingPoint::Control::load) {
    const Eigen::Vector2d missing = to.journal - film_force(bearing_, state.foil.film.pressure);
    square += missing.squaredNorm() / (bearing_.scales.force() * bearing_.scales.force());
  } else {
    const double way = weight_of_way * (to.journal - state.position).norm() / bearing_.scales.thickness;
    square += way * way;
  }
  return std::sqrt(square);
}

/// The condensed film and the bump foil in one matrix. Unknowns are in m, rows in N.
void FilmNewton::assemble() {
  const double scale = bearing_.foil.stiffness;
  const int blocks = system_.blocks();
  K_ = bump_K_;
  for (int b = 0; b < blocks; ++b) {
    const auto i = static_cast<std::size_t>(b);
    for_each_place(b, [&](int row, int film_row) {
      for_each_place(b, [&](int place, int film_place) {
        K_.diagonal[i](row, place) += scale * system_.diagonal(b)(film_row, film_place);
      });
      if (b > 0) {
        for_each_place(b - 1, [&](int place, int film_place) {
          K_.lower[i - 1](row, place) += scale * system_.lower(b)(film_row, film_place);
        });
      }
      if (b + 1 < blocks) {
        for_each_place(b + 1, [&](int place, int film_place) {
          K_.upper[i](row, place) += scale * system_.upper(b)(film_row, film_place);
        });
      }
    });
  }
}

/// Adds the condensed residuals to the loads of the contact problem.
void FilmNewton::load_condensed() {
  const double unit = bearing_.foil.stiffness * bearing_.scales.thickness;
  const Matrix& condensed = system_.condense(residual_);
  for (int b = 0; b < system_.blocks(); ++b) {
    for_each_place(b, [&](int place, int film_place) {
      loading_.load[Eigen::Index{b} * K_.block_size() + place] -= unit * condensed(film_place, b);
    });
  }
}

/// Changes of the blocks, as the contact problem found them, and of what lies in between.
void FilmNewton::expand(const Vector& x, FoilFilmState& change) {
  support_step_.setZero();
  for (int b = 0; b < system_.blocks(); ++b) {
    for_each_place(b, [&](int place, int film_place) {
      support_step_(film_place, b) = x[Eigen::Index{b} * K_.block_size() + place] / bearing_.scales.thickness;
    });
  }
  system_.expand(support_step_, change);
}

/// Change of H where the journal moves and the foil does not.
Matrix FilmNewton::thinning(const Eigen::Vector2d& displacement) const {
  return (displacement.transpose() * bearing_.normals / -bearing_.scales.thickness)
      .replicate(bearing_.foil.mesh.rows + 1, 1);
}

/// Change of all unknowns that takes residuals of the film, and no others, to zero: where the system was linearised
/// last, with the modes that were set last.
void FilmNewton::answer(Matrix film_residual, Step& change) {
  const FilmMesh& mesh = bearing_.foil.mesh;
  residual_.film = std::move(film_residual);
  residual_.balance.setZero(mesh.nodes());
  residual_.compatibility.setZero(mesh.nodes());
  loading_.initial_gap.setZero();
  loading_.load.setZero();
  load_condensed();
  modes_->solve(loading_, Vector::Zero(K_.rows()), change.contact);
  expand(change.contact.x, change.foil);
}

/// Change of the force on the journal with the pressure.
Eigen::Vector2d FilmNewton::force_of(const FoilFilmState& change) const {
  return film_force(bearing_, bearing_.foil.mesh.field(1.0) + change.film.pressure);
}

/// Rates of all unknowns per displacement of the journal where the system was linearised last, with the modes that
/// were set last. @return those of the force on the journal, N/m
Eigen::Matrix2d FilmNewton::find_rates() {
  Eigen::Matrix2d K_film;
  for (const int axis : {0, 1}) {
    Step& rate = rates_[static_cast<std::size_t>(axis)];
    const Matrix rigid = thinning(Eigen::Vector2d::Unit(axis));
    answer(stencil_product(bearing_.foil.mesh, system_.film_jacobian().by_thickness, rigid), rate);
    rate.foil.film.thickness += rigid;
    K_film.col(axis) = force_of(rate.foil);
  }
  return K_film;
}

/// Linearises about a state, with contacts in its modes, or with all closed ones stuck.
/// @return whether that leaves a regular system
bool FilmNewton::linearise(const ReynoldsEquation& equation, const FilmBearingState& state, bool stuck) {
  if (!system_.linearise(equation, state.foil)) return false;
  assemble();
  modes_->set_elasticity(K_);
  std::vector<ContactMode> held = state.contact.mode;
  for (ContactMode& mode : held) {
    if (stuck && mode != ContactMode::open) mode = ContactMode::stick;
  }
  return modes_->set_modes(held);
}

std::optional<Eigen::Matrix2d> FilmNewton::stiffness(const FilmBearingState& state, bool stuck) {
  if (!linearise(film_equation(bearing_, state.speed), state, stuck)) return std::nullopt;
  return find_rates();
}

std::optional<std::vector<Eigen::Matrix2cd>> FilmNewton::impedances(const FilmBearingState& state,
                                                                    const std::vector<std::complex<double>>& rates,
                                                                    bool stuck) {
  const FilmMesh& mesh = bearing_.foil.mesh;
  const double T0 = bearing_.scales.squeeze_time();
  ReynoldsEquation equation = film_equation(bearing_, state.speed);
  for (const std::complex<double> rate : rates) equation.squeeze_rate = std::max(equation.squeeze_rate, std::abs(rate));
  equation.squeeze_rate *= T0;
  equation.previous_content = film_content(state.foil.film);
  if (!linearise(equation, state, stuck)) return std::nullopt;

  std::vector<std::complex<double>> excess;
  excess.reserve(rates.size());
  for (const std::complex<double> rate : rates) excess.push_back(T0 * rate - equation.squeeze_rate);
  const auto told = [&](const FoilFilmState& change) {
    const Matrix content = change.film.pressure.cwiseProduct(state.foil.film.thickness) +
                           state.foil.film.pressure.cwiseProduct(change.film.thickness);
    const Matrix inside = content.block(0, mesh.first_unknown(), mesh.unknown_rows(), mesh.unknown_columns());
    return FilmAnswer{inside.reshaped(), force_of(change)};
  };
  Step change;
  const auto stored = [&](const Vector& content) {
    Matrix residual = mesh.field(0.0);
    residual.block(0, mesh.first_unknown(), mesh.unknown_rows(), mesh.unknown_columns()) =
        mesh.dtheta * mesh.dzeta * content.reshaped(mesh.unknown_rows(), mesh.unknown_columns());
    for (int j = 0; j < mesh.unknown_rows(); ++j) residual.row(j) *= mesh.row_weight(j);
    answer(std::move(residual), change);
    return told(change.foil);
  };
  find_rates();
  std::vector<Eigen::Matrix2cd> found(rates.size());
  for (const int axis : {0, 1}) {
    const auto forces = film_forces(told(rates_[static_cast<std::size_t>(axis)].foil), stored, excess);
    if (!forces) return std::nullopt;
    for (std::size_t i = 0; i < rates.size(); ++i) found[i].col(axis) = (*forces)[i];
  }
  return found;
}

/// Newton's step at the position of `state` with exact contacts: the unknowns of the contact problem are the steps of
/// the blocks.
bool FilmNewton::find_step(const ContactState& previous, const FilmBearingState& state, FilmReport& report) {
  const Vector& x = state.contact.x;
  // Contact forces are unknowns of the step, and no part of its right-hand side.
  loading_.load = -find_bump_forces(state.contact);
  load_condensed();
  loading_.initial_gap = contact_gaps(bearing_.problem, bearing_.initial_gap, x);
  begin_ = state.contact;
  begin_.x.setZero();
  for_each_contact(bearing_.problem, [&](const CoulombContact& contact) {
    if (contact.pair.tangential < 0) return;
    const Eigen::Index place = contact.row + contact.pair.tangential;
    begin_.x[place] = previous.x[place] - x[place];
  });
  assemble();
  contacts_.set_elasticity(K_);
  const SolveReport solved = contacts_.solve(loading_, begin_, step_.contact);
  report.factorisations += solved.cost.factorisations;
  if (!solved.converged()) return false;
  expand(step_.contact.x, step_.foil);
  step_.displacement.setZero();
  return true;
}

/// What is left of the way to the position where the journal is held or, with the step and the rates, of the load.
Eigen::Vector2d FilmNewton::missing_displacement(const OperatingPoint& to, const FilmBearingState& state) {
  if (to.control == OperatingPoint::Control::position) {
    Eigen::Vector2d way = to.journal - state.position;
    if (way.norm() <= rounded_displacement * bearing_.scales.thickness) return Eigen::Vector2d::Zero();
    find_rates();
    return way;
  }
  const Eigen::Vector2d missing =
      to.journal - film_force(bearing_, state.foil.film.pressure + step_.foil.film.pressure);
  return find_rates().partialPivLu().solve(missing);
}

/// Lets the journal move with the step, by as much as it is to: the linearised equations stay solved, in the modes that
/// the step has without it.
void FilmNewton::move_journal(const OperatingPoint& to, const FilmBearingState& state) {
  Eigen::Vector2d displacement = missing_displacement(to, state);
  if (displacement.isZero(0.0)) return;
  const bool held = to.control == OperatingPoint::Control::position;
  const double longest = (held ? longest_displacement : longest_displacement_under_load) * bearing_.scales.thickness;
  if (displacement.norm() > longest) displacement *= longest / displacement.norm();
  step_.displacement = displacement;
  for (const int axis : {0, 1}) {
    const double way = displacement[axis];
    const Step& rate = rates_[static_cast<std::size_t>(axis)];
    step_.foil.film.pressure += way * rate.foil.film.pressure;
    step_.foil.film.thickness += way * rate.foil.film.thickness;
    step_.foil.lift += way * rate.foil.lift;
    step_.foil.moment += way * rate.foil.moment;
    step_.contact.x += way * rate.contact.x;
    step_.contact.gap += way * rate.contact.gap;
    step_.contact.normal_force += way * rate.contact.normal_force;
    step_.contact.friction_force += way * rate.contact.friction_force;
  }
}

void FilmNewton::take_step(double fraction, const FilmBearingState& from, FilmBearingState& to) const {
  const FoilFilmState& step = step_.foil;
  to.position = from.position + fraction * step_.displacement;
  to.speed = from.speed;
  to.foil.film.pressure = from.foil.film.pressure + fraction * step.film.pressure;
  to.foil.film.thickness = from.foil.film.thickness + fraction * step.film.thickness;
  to.foil.lift = from.foil.lift + fraction * step.lift;
  to.foil.moment = from.foil.moment + fraction * step.moment;
  to.contact.x = from.contact.x + fraction * step_.contact.x;
  const auto mix = [fraction](const Vector& a, const Vector& b) -> Vector { return a + fraction * (b - a); };
  to.contact.gap = mix(from.contact.gap, step_.contact.gap);
  to.contact.normal_force = mix(from.contact.normal_force, step_.contact.normal_force);
  to.contact.friction_force = mix(from.contact.friction_force, step_.contact.friction_force);
  to.contact.mode = step_.contact.mode;
}

FilmReport FilmNewton::solve(const OperatingPoint& to, const ReynoldsEquation& equation, double tolerance,
                             const ContactState& previous, FilmBearingState& state) {
  FilmReport report;
  iterate_ = state;
  iterate_.speed = to.speed;
  iterate_.foil.film.thickness = bearing_.undeformed_thickness(state.position);
  iterate_.foil.film.thickness.rowwise() += iterate_.foil.lift.transpose();
  if (iterate_.foil.film.thickness.minCoeff() <= 0.0) {
    report.status = FilmStatus::no_room;
    return report;
  }
  report.residual = find_residual(to, equation, iterate_);
  while (report.iterations < options_.max_iterations) {
    ++report.iterations;
    if (!system_.linearise(equation, iterate_.foil) || !find_step(previous, iterate_, report)) return report;
    move_journal(to, iterate_);
    const double fraction = longest_step(options_, iterate_.foil.film, step_.foil.film);
    const double largest =
        std::max({step_.foil.film.pressure.cwiseAbs().maxCoeff(), step_.foil.lift.cwiseAbs().maxCoeff(),
                  step_.displacement.norm() / bearing_.scales.thickness});
    if (fraction == 1.0 && largest < tolerance) {
      take_step(1.0, iterate_, trial_);
      const bool touches = trial_.foil.film.thickness.minCoeff() < options_.thickness_floor;
      report.status = touches ? FilmStatus::touchdown : FilmStatus::converged;
      if (to.control == OperatingPoint::Control::position) trial_.position = to.journal;
      if (!touches) std::swap(state, trial_);
      return report;
    }
    double part = fraction;
    for (int halvings = 0;; ++halvings) {
      if (halvings == max_halvings) part = forced_fraction * fraction;
      take_step(part, iterate_, trial_);
      const double norm = find_residual(to, equation, trial_);
      if (norm < report.residual || halvings == max_halvings) {
        report.residual = norm;
        break;
      }
      part *= 0.5;
    }
    std::swap(iterate_, trial_);
  }
  return report;
}

}  // namespace bumpfoil
