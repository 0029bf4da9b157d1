#include "bumpfoil/analysis/film_bearing_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/newton.hpp"

namespace bumpfoil {
namespace {

constexpr int max_halvings = 8;
/// Part of a step that is taken where no halving lets the residual fall.
constexpr double forced_fraction = 0.25;
/// Steps that take no more iterations than this let the next one grow.
constexpr int easy_iterations = 12;
/// Time steps are given up below this part of the first.
constexpr double smallest_time_step = 1e-6;

}  // namespace

struct FilmBearingSolver::Workspace {
  Workspace(const FilmBearing& film_bearing, const FilmBearingOptions& solver_options)
      : bearing(film_bearing),
        options(solver_options),
        system(film_bearing.foil),
        contacts(film_bearing.problem),
        modes(make_mode_system(film_bearing.problem)),
        K(film_bearing.problem.K),
        loading(ContactLoading::none(film_bearing.problem)),
        begin(ContactState::unstressed(film_bearing.problem)),
        support_step(film_bearing.foil.mesh.rows + 2, system.blocks()) {
    for (const Matrix& block : K.upper) K.lower.push_back(block.transpose());
    bump_K = K;
  }

  FilmReport solve(const ReynoldsEquation& equation, const ContactState& previous, FilmBearingState& state);
  FilmReport march(FilmBearingState& state);

  Vector& find_bump_forces(const ContactState& state);
  double find_residual(const ReynoldsEquation& equation, const FilmBearingState& state);
  void assemble();
  void load_condensed();
  void expand_step();
  std::optional<Eigen::Matrix2d> stiffness(const FilmBearingState& state, bool stuck);
  bool find_step(const ContactState& previous, const FilmBearingState& state, FilmReport& report);
  void take_step(double fraction, const FilmBearingState& from, FilmBearingState& to) const;
  /// Calls visit(place in the block of contacts, row of the film's block) for the unknowns of block b that the film
  /// knows.
  template <typename Visitor>
  void for_each_place(int b, Visitor&& visit) const;

  FilmBearing bearing;
  FilmBearingOptions options;
  FoilFilmSystem system;
  NewtonSolver contacts;
  std::unique_ptr<ModeSystem> modes;  ///< of stiffness()
  BlockTridiagonal K, bump_K;
  ContactLoading loading;
  ContactState begin, next;
  Matrix support_step;
  FoilFilmResidual residual;
  Vector bump_forces;
  FoilFilmState step;
  FilmBearingState iterate, trial;
};

template <typename Visitor>
void FilmBearingSolver::Workspace::for_each_place(int b, Visitor&& visit) const {
  const int n = bearing.foil.mesh.rows;
  const int first_pressure = bearing.dofs.size;
  if (b + 1 == system.blocks()) {
    visit(first_pressure, n);  // the free end
    return;
  }
  for (int j = 0; j < n; ++j) visit(first_pressure + j, j);
  visit(bearing.dofs.top_u, n);
  visit(bearing.dofs.top_moment, n + 1);
}

/// Forces that the bump foil takes at its displacements, N; what is held in the last block takes none.
Vector& FilmBearingSolver::Workspace::find_bump_forces(const ContactState& state) {
  bump_forces = bump_K.multiply(state.x);
  bump_forces.tail(bump_K.block_size()).setZero();
  return bump_forces;
}

/// Residuals of film and foil without contact forces; returns the norm of all residuals, with them: the film per area
/// of a cell, forces by EI' c / p^3, compatibility by c / p.
double FilmBearingSolver::Workspace::find_residual(const ReynoldsEquation& equation, const FilmBearingState& state) {
  const FilmMesh& mesh = bearing.foil.mesh;
  foil_film_residual(bearing.foil, equation, state.foil, residual);
  const double film =
      residual.film.block(0, mesh.first_unknown(), mesh.unknown_rows(), mesh.unknown_columns()).squaredNorm() /
      (mesh.dtheta * mesh.dtheta * mesh.dzeta * mesh.dzeta);

  const ContactState& contact = state.contact;
  Vector& forces = find_bump_forces(contact);
  forces -= contact_forces(bearing.problem, contact.normal_force, contact.friction_force);
  const double unit = bearing.foil.stiffness * bearing.scales.thickness;
  double balance = residual.balance.squaredNorm();
  for (std::size_t i = 0; i < bearing.foil.supports.size(); ++i) {
    const double held = residual.balance[bearing.foil.supports[i]];
    double& support = forces[static_cast<Eigen::Index>(i) * bump_K.block_size() + bearing.dofs.top_u];
    balance += (held + support / unit) * (held + support / unit) - held * held;
    support = 0.0;
  }
  return std::sqrt(film + balance + residual.compatibility.squaredNorm() + forces.squaredNorm() / (unit * unit));
}

/// The condensed film and the bump foil in one matrix. Unknowns are in m, rows in N.
void FilmBearingSolver::Workspace::assemble() {
  const double scale = bearing.foil.stiffness;
  const int blocks = system.blocks();
  K = bump_K;
  for (int b = 0; b < blocks; ++b) {
    const auto i = static_cast<std::size_t>(b);
    for_each_place(b, [&](int row, int film_row) {
      for_each_place(b, [&](int place, int film_place) {
        K.diagonal[i](row, place) += scale * system.diagonal(b)(film_row, film_place);
      });
      if (b > 0) {
        for_each_place(b - 1, [&](int place, int film_place) {
          K.lower[i - 1](row, place) += scale * system.lower(b)(film_row, film_place);
        });
      }
      if (b + 1 < blocks) {
        for_each_place(b + 1, [&](int place, int film_place) {
          K.upper[i](row, place) += scale * system.upper(b)(film_row, film_place);
        });
      }
    });
  }
}

/// Adds the condensed residuals to the loads of the contact problem.
void FilmBearingSolver::Workspace::load_condensed() {
  const double unit = bearing.foil.stiffness * bearing.scales.thickness;
  const Matrix& condensed = system.condense(residual);
  for (int b = 0; b < system.blocks(); ++b) {
    for_each_place(b, [&](int place, int film_place) {
      loading.load[Eigen::Index{b} * K.block_size() + place] -= unit * condensed(film_place, b);
    });
  }
}

/// Reads the steps of the blocks off the contact problem, and those in between.
void FilmBearingSolver::Workspace::expand_step() {
  support_step.setZero();
  for (int b = 0; b < system.blocks(); ++b) {
    for_each_place(b, [&](int place, int film_place) {
      support_step(film_place, b) = next.x[Eigen::Index{b} * K.block_size() + place] / bearing.scales.thickness;
    });
  }
  system.expand(support_step, step);
}

/// Rates per displacement of the journal, modes held.
std::optional<Eigen::Matrix2d> FilmBearingSolver::Workspace::stiffness(const FilmBearingState& state, bool stuck) {
  const FilmMesh& mesh = bearing.foil.mesh;
  if (!system.linearise(film_equation(bearing, state.speed), state.foil)) return std::nullopt;
  assemble();
  modes->set_elasticity(K);
  std::vector<ContactMode> held = state.contact.mode;
  for (ContactMode& mode : held) {
    if (stuck && mode != ContactMode::open) mode = ContactMode::stick;
  }
  if (!modes->set_modes(held)) return std::nullopt;
  Eigen::Matrix2d K_film;
  for (const int axis : {0, 1}) {
    const Matrix thinning = bearing.normals.row(axis).replicate(mesh.rows + 1, 1) / -bearing.scales.thickness;
    residual.film = stencil_product(mesh, system.film_jacobian().by_thickness, thinning);
    residual.balance.setZero(mesh.nodes());
    residual.compatibility.setZero(mesh.nodes());
    loading.load.setZero();
    loading.initial_gap.setZero();
    load_condensed();
    modes->solve(loading, Vector::Zero(K.rows()), next);
    expand_step();
    const FilmState rate{mesh.field(1.0) + step.film.pressure, state.foil.film.thickness};
    const FilmIntegrals sums = film_integrals({.mesh = mesh}, rate);
    K_film.col(axis) = plane_force(bearing, sums);
  }
  return K_film;
}

/// Newton's step with exact contacts: the unknowns of the contact problem are the steps of the blocks.
bool FilmBearingSolver::Workspace::find_step(const ContactState& previous, const FilmBearingState& state,
                                             FilmReport& report) {
  const Vector& x = state.contact.x;
  // Contact forces are unknowns of the step, and no part of its right-hand side.
  loading.load = -find_bump_forces(state.contact);
  load_condensed();
  loading.initial_gap = contact_gaps(bearing.problem, bearing.initial_gap, x);
  begin = state.contact;
  begin.x.setZero();
  for_each_contact(bearing.problem, [&](const CoulombContact& contact) {
    if (contact.pair.tangential < 0) return;
    const Eigen::Index place = contact.row + contact.pair.tangential;
    begin.x[place] = previous.x[place] - x[place];
  });
  assemble();
  contacts.set_elasticity(K);
  const SolveReport solved = contacts.solve(loading, begin, next);
  report.factorisations += solved.cost.factorisations;
  if (!solved.converged()) return false;
  expand_step();
  return true;
}

void FilmBearingSolver::Workspace::take_step(double fraction, const FilmBearingState& from,
                                             FilmBearingState& to) const {
  to.position = from.position;
  to.speed = from.speed;
  to.foil.film.pressure = from.foil.film.pressure + fraction * step.film.pressure;
  to.foil.film.thickness = from.foil.film.thickness + fraction * step.film.thickness;
  to.foil.lift = from.foil.lift + fraction * step.lift;
  to.foil.moment = from.foil.moment + fraction * step.moment;
  to.contact.x = from.contact.x + fraction * next.x;
  const auto mix = [fraction](const Vector& a, const Vector& b) -> Vector { return a + fraction * (b - a); };
  to.contact.gap = mix(from.contact.gap, next.gap);
  to.contact.normal_force = mix(from.contact.normal_force, next.normal_force);
  to.contact.friction_force = mix(from.contact.friction_force, next.friction_force);
  to.contact.mode = next.mode;
}

/// Newton's method at the position and speed of `state`, with the lift of the foil as the first guess.
FilmReport FilmBearingSolver::Workspace::solve(const ReynoldsEquation& equation, const ContactState& previous,
                                               FilmBearingState& state) {
  FilmReport report;
  iterate = state;
  iterate.foil.film.thickness = bearing.undeformed_thickness(state.position);
  iterate.foil.film.thickness.rowwise() += iterate.foil.lift.transpose();
  if (iterate.foil.film.thickness.minCoeff() <= 0.0) {
    report.status = FilmStatus::no_room;
    return report;
  }
  while (report.iterations < options.newton.max_iterations) {
    ++report.iterations;
    const double norm = find_residual(equation, iterate);
    report.residual = norm;
    if (!system.linearise(equation, iterate.foil) || !find_step(previous, iterate, report)) return report;
    const double fraction = longest_step(options.newton, iterate.foil.film, step.film);
    const double largest = std::max(step.film.pressure.cwiseAbs().maxCoeff(), step.lift.cwiseAbs().maxCoeff());
    if (fraction == 1.0 && largest < options.newton.step_tolerance) {
      take_step(1.0, iterate, trial);
      const bool touches = trial.foil.film.thickness.minCoeff() < options.newton.thickness_floor;
      report.status = touches ? FilmStatus::touchdown : FilmStatus::converged;
      if (!touches) std::swap(state, trial);
      return report;
    }
    double part = fraction;
    for (int halvings = 0;; ++halvings) {
      if (halvings == max_halvings) part = forced_fraction * fraction;
      take_step(part, iterate, trial);
      if (find_residual(equation, trial) < norm || halvings == max_halvings) break;
      part *= 0.5;
    }
    std::swap(iterate, trial);
  }
  return report;
}

FilmReport FilmBearingSolver::Workspace::march(FilmBearingState& state) {
  const double T0 = bearing.scales.squeeze_time();
  const ContactState unstressed = state.contact;
  ReynoldsEquation equation = film_equation(bearing, state.speed);
  FilmReport total;
  const double first = options.first_time_step * T0;
  for (double dt = first;;) {
    equation.squeeze_rate = T0 / dt;
    equation.previous_content = film_content(state.foil.film);
    const Matrix pressure = state.foil.film.pressure;
    const Vector lift = state.foil.lift;
    const FilmReport report = solve(equation, unstressed, state);
    total.iterations += report.iterations;
    total.factorisations += report.factorisations;
    if (report.status != FilmStatus::converged) {
      dt *= 0.25;
      total.status = report.status;
      if (dt < smallest_time_step * first) return total;
      continue;
    }
    const double change = std::max((state.foil.film.pressure - pressure).cwiseAbs().maxCoeff(),
                                   (state.foil.lift - lift).cwiseAbs().maxCoeff());
    if (dt > options.last_time_step && change < options.resting_change) break;
    dt *= options.time_growth;
  }
  const FilmReport report = solve(film_equation(bearing, state.speed), unstressed, state);
  total.iterations += report.iterations;
  total.factorisations += report.factorisations;
  total.status = report.status;
  total.residual = report.residual;
  return total;
}

FilmBearingSolver::FilmBearingSolver(const FilmBearing& bearing, const FilmBearingOptions& options)
    : workspace_(std::make_unique<Workspace>(bearing, options)) {}

FilmBearingSolver::~FilmBearingSolver() = default;

FilmReport FilmBearingSolver::solve(const Eigen::Vector2d& position, double speed, const ContactState& previous,
                                    FilmBearingState& state) {
  FilmBearingState target = state;
  target.position = position;
  target.speed = speed;
  const FilmReport report = workspace_->solve(film_equation(workspace_->bearing, speed), previous, target);
  if (report.status == FilmStatus::converged) state = std::move(target);
  return report;
}

FilmReport FilmBearingSolver::cold_start(const Eigen::Vector2d& position, double speed, FilmBearingState& state) {
  FilmBearingState start = resting(workspace_->bearing, position, speed);
  const FilmReport report = workspace_->march(start);
  if (report.status == FilmStatus::converged) state = std::move(start);
  return report;
}

std::optional<Eigen::Matrix2d> FilmBearingSolver::stiffness(const FilmBearingState& state, bool stuck) {
  return workspace_->stiffness(state, stuck);
}

FilmReport FilmBearingSolver::follow(const Eigen::Vector2d& position, double speed, FilmBearingState& state) {
  const FilmBearingOptions& options = workspace_->options;
  const Eigen::Vector2d from = state.position;
  const double speed_from = state.speed;
  const double way = std::max(
      {(position - from).norm() / (options.position_step * workspace_->bearing.scales.thickness),
       std::abs(speed - speed_from) / (options.speed_step * std::max(std::abs(speed), std::abs(speed_from))), 1.0});
  FilmReport total;
  double step = 1.0 / way;
  for (double reached = 0.0; reached < 1.0;) {
    const double next = std::min(1.0, reached + step);
    const ContactState previous = state.contact;
    const FilmReport report =
        solve(from + next * (position - from), speed_from + next * (speed - speed_from), previous, state);
    total.iterations += report.iterations;
    total.factorisations += report.factorisations;
    total.residual = report.residual;
    total.status = report.status;
    if (report.status == FilmStatus::converged) {
      reached = next;
      if (report.iterations < easy_iterations) step *= options.time_growth;
    } else {
      step *= 0.5;
      if (step * way < options.smallest_fraction) return total;
    }
  }
  return total;
}

}  // namespace bumpfoil
