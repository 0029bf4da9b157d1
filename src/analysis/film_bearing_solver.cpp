#include "bumpfoil/analysis/film_bearing_solver.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/film_newton.hpp"

namespace bumpfoil {
namespace {

/// Steps that take no more iterations than this let the next one grow.
constexpr int easy_iterations = 12;
/// Of steps that look for another branch.
constexpr double step_growth_off_branch = 8.0;
/// Time steps are given up below this part of the first.
constexpr double smallest_time_step = 1e-6;

FilmReport& operator+=(FilmReport& total, const FilmReport& more) {
  total.status = more.status;
  total.iterations += more.iterations;
  total.factorisations += more.factorisations;
  total.residual = more.residual;
  total.jumps += more.jumps;
  return total;
}

OperatingPoint between(const OperatingPoint& from, const OperatingPoint& to, double fraction) {
  return {to.control, from.journal + fraction * (to.journal - from.journal),
          from.speed + fraction * (to.speed - from.speed), from.opening + fraction * (to.opening - from.opening)};
}

/// Where a branch ends on a line of operating points, in parts of the line.
struct BranchEnd {
  const OperatingPoint& from;
  const OperatingPoint& to;
  double begin{};                ///< of the last state
  double shortest{}, longest{};  ///< steps
};

}  // namespace

struct FilmBearingSolver::Workspace {
  Workspace(const FilmBearing& film_bearing, const FilmBearingOptions& solver_options)
      : bearing(film_bearing), options(solver_options), newton(film_bearing, solver_options.newton) {}

  FilmReport solve(const OperatingPoint& to, const FilmEquations& equations, const ContactState& previous,
                   FilmBearingState& state);
  FilmReport solve_on_branch(const OperatingPoint& to, const ContactState& previous, FilmBearingState& state);
  FilmReport settle(const OperatingPoint& to, const ContactState& previous, FilmBearingState& state);
  double jump(const BranchEnd& end, const ContactState& previous, FilmBearingState& state, FilmReport& total);
  [[nodiscard]] double steps_between(const OperatingPoint& from, const OperatingPoint& to) const;

  FilmBearing bearing;
  FilmBearingOptions options;
  FilmNewton newton;
};

FilmReport FilmBearingSolver::Workspace::solve(const OperatingPoint& to, const FilmEquations& equations,
                                               const ContactState& previous, FilmBearingState& state) {
  if (options.keep_going && !options.keep_going()) return {.status = FilmStatus::interrupted};
  // A step in time is but a guess of the next.
  const double tolerance =
      equations.front().squeeze_rate > 0.0 ? options.marching_tolerance : options.newton.step_tolerance;
  return newton.solve(to, equations, tolerance, previous, state);
}

/// solve() from one state to the next, under a load on the same branch: a state that lies off the tangent's prediction
/// by more than curvature and contacts explain is not accepted, as Newton's method has reached another branch.
FilmReport FilmBearingSolver::Workspace::solve_on_branch(const OperatingPoint& to, const ContactState& previous,
                                                         FilmBearingState& state) {
  FilmBearingState found = state;
  FilmReport report = solve(to, film_equations(bearing, to.speed), previous, found);
  if (report.status != FilmStatus::converged) return report;
  if (to.control == OperatingPoint::Control::load &&
      report.departure > std::max(options.largest_departure * report.predicted_change, options.resolved_departure)) {
    report.status = FilmStatus::not_converged;
    return report;
  }
  state = std::move(found);
  return report;
}

/// To another branch, from the last state of one: to where the film comes to rest in time behind the end. Under a load,
/// if it rests nowhere, to the state that Newton's method reaches in the shortest step that it converges in.
/// @return the part of the line where that is
double FilmBearingSolver::Workspace::jump(const BranchEnd& end, const ContactState& previous, FilmBearingState& state,
                                          FilmReport& total) {
  double reached = end.begin + end.shortest;
  const FilmReport rested = settle(between(end.from, end.to, reached), previous, state);
  total += rested;
  const bool gives_up = rested.status == FilmStatus::interrupted || end.to.control == OperatingPoint::Control::position;
  for (double step = end.shortest; total.status != FilmStatus::converged && !gives_up; step *= step_growth_off_branch) {
    reached = std::min(1.0, end.begin + std::min(step, end.longest));
    const OperatingPoint there = between(end.from, end.to, reached);
    total += solve(there, film_equations(bearing, there.speed), previous, state);
    if (total.status == FilmStatus::interrupted) return reached;
    if (step >= end.longest) break;
  }
  if (total.status == FilmStatus::converged) {
    ++total.jumps;
  } else {
    total.status = rested.status == FilmStatus::not_converged ? FilmStatus::fold : rested.status;
  }
  return reached;
}

FilmReport FilmBearingSolver::Workspace::settle(const OperatingPoint& to, const ContactState& previous,
                                                FilmBearingState& state) {
  const double T0 = bearing.scales.squeeze_time();
  const double first = options.first_time_step * T0;
  FilmEquations equations = film_equations(bearing, to.speed);
  FilmBearingState moving = state;
  FilmReport total;
  double dt = first;
  for (int steps = 0;; ++steps) {
    if (steps == options.max_time_steps) {
      total.status = FilmStatus::not_converged;
      return total;
    }
    squeeze(bearing, T0 / dt, film_content(moving.foil.film), equations);
    const Matrix pressure = moving.foil.film.pressure;
    const Vector lift = moving.foil.lift;
    const Eigen::Vector2d position = moving.position;
    total += solve(to, equations, previous, moving);
    if (total.status == FilmStatus::interrupted) return total;
    if (total.status != FilmStatus::converged) {
      dt *= 0.25;
      if (dt < smallest_time_step * first) return total;
      continue;
    }
    const double change = std::max({(moving.foil.film.pressure - pressure).cwiseAbs().maxCoeff(),
                                    (moving.foil.lift - lift).cwiseAbs().maxCoeff(),
                                    (moving.position - position).norm() / bearing.scales.thickness});
    if (dt > options.last_time_step && change < options.resting_change) break;
    dt *= options.time_growth;
  }
  total += solve(to, film_equations(bearing, to.speed), previous, moving);
  if (total.status == FilmStatus::converged) state = std::move(moving);
  return total;
}

/// Steps of first length on the way from one operating point to another, at least one.
double FilmBearingSolver::Workspace::steps_between(const OperatingPoint& from, const OperatingPoint& to) const {
  const double speed = std::max(std::abs(from.speed), std::abs(to.speed));
  double steps = std::max(1.0, std::abs(to.speed - from.speed) / (options.speed_step * speed));
  steps = std::max(steps, std::abs(to.opening - from.opening) / (options.position_step * bearing.scales.thickness));
  if (to.control == OperatingPoint::Control::position) {
    steps = std::max(steps, (to.journal - from.journal).norm() / (options.position_step * bearing.scales.thickness));
  }
  return steps;
}

FilmBearingSolver::FilmBearingSolver(const FilmBearing& bearing, const FilmBearingOptions& options)
    : workspace_(std::make_unique<Workspace>(bearing, options)) {}

FilmBearingSolver::~FilmBearingSolver() = default;

const FilmBearing& FilmBearingSolver::bearing() const {
  return workspace_->bearing;
}

FilmReport FilmBearingSolver::solve(const OperatingPoint& to, const ContactState& previous, FilmBearingState& state) {
  return workspace_->solve(to, film_equations(workspace_->bearing, to.speed), previous, state);
}

// A copy: it may be that of the state, which changes. NOLINTNEXTLINE(performance-unnecessary-value-param)
FilmReport FilmBearingSolver::settle(const OperatingPoint& to, ContactState previous, FilmBearingState& state) {
  return workspace_->settle(to, previous, state);
}

FilmReport FilmBearingSolver::cold_start(const Eigen::Vector2d& position, double speed, FilmBearingState& state,
                                         double opening) {
  FilmBearingState start = resting(workspace_->bearing, position, speed, opening);
  const ContactState unstressed = start.contact;
  const FilmReport report = workspace_->settle(OperatingPoint::held_at(position, speed, opening), unstressed, start);
  if (report.status == FilmStatus::converged) state = std::move(start);
  return report;
}

std::optional<SlowMotion> FilmBearingSolver::slow_motion(const FilmBearingState& state, bool stuck) {
  return workspace_->newton.slow_motion(state, stuck);
}

std::optional<Eigen::Matrix2d> FilmBearingSolver::stiffness(const FilmBearingState& state, bool stuck) {
  const std::optional<SlowMotion> motion = slow_motion(state, stuck);
  return motion ? std::optional(motion->stiffness) : std::nullopt;
}

std::optional<std::vector<Eigen::Matrix2cd>> FilmBearingSolver::impedances(
    const FilmBearingState& state, const std::vector<std::complex<double>>& rates, bool stuck) {
  return workspace_->newton.impedances(state, rates, stuck);
}

// A copy: it may be that of the state, which changes. NOLINTNEXTLINE(performance-unnecessary-value-param)
FilmReport FilmBearingSolver::follow(const OperatingPoint& to, ContactState previous, FilmBearingState& state) {
  Workspace& w = *workspace_;
  const bool by_load = to.control == OperatingPoint::Control::load;
  const OperatingPoint from{to.control, by_load ? film_force(w.bearing, state.foil.film.pressure) : state.position,
                            state.speed, state.opening};
  const double steps = w.steps_between(from, to);
  const double smallest = by_load ? w.options.smallest_load_fraction : w.options.smallest_fraction;
  FilmReport total;
  double step = 1.0 / steps;
  for (double reached = 0.0; reached < 1.0;) {
    const double next = std::min(1.0, reached + step);
    const OperatingPoint there = between(from, to, next);
    const FilmReport report = w.solve_on_branch(there, previous, state);
    total += report;
    if (report.status == FilmStatus::interrupted) return total;
    if (report.status == FilmStatus::converged) {
      reached = next;
      if (report.iterations < easy_iterations) step *= w.options.time_growth;
      continue;
    }
    step *= 0.5;
    if (step * steps >= smallest) continue;
    if (report.status != FilmStatus::not_converged) return total;
    // The branch ends: no state near the last one goes on.
    if (total.jumps == w.options.max_jumps) {
      total.status = FilmStatus::fold;
      return total;
    }
    reached = w.jump({.from = from, .to = to, .begin = reached, .shortest = next - reached, .longest = 1.0 / steps},
                     previous, state, total);
    if (total.status != FilmStatus::converged) return total;
    step = 1.0 / steps;
  }
  return total;
}

}  // namespace bumpfoil
