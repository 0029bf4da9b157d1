#include "bumpfoil/bearing/film_bearing_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bearing/film_newton.hpp"

namespace bumpfoil {
namespace {

/// Steps that take no more iterations than this let the next one grow.
constexpr int easy_iterations = 12;
/// Of steps that look for another branch, and of those that begin behind the end of one.
constexpr double step_growth_off_branch = 8.0;
/// Time steps are given up below this part of the first.
constexpr double smallest_time_step = 1e-6;
/// As long as a march in time is near its start (largest difference of P, U and position over c) a step changes the
/// state by no more than this many times what the step before did. Where a state is left at the rate s, implicit Euler
/// multiplies the distance from it by 1 / (1 - s dt): longer steps blow it up, those beyond s dt = 1 turn its sign, and
/// the march ends in whatever state lies on that side. Not below this part of the first step: foils that snap over do
/// so at once.
constexpr double near_start = 0.1;
constexpr double largest_change_ratio = 4.0;
constexpr double shortest_bounded_step = 1e-3;

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

/// How far a path on a line of operating points has come, in parts of the line, where its branch ends.
struct BranchEnd {
  const OperatingPoint& from;
  const OperatingPoint& to;
  double longest{};          ///< step
  double reached{}, leap{};  ///< the last state, and the next behind it
  bool comes_to_rest{true};  ///< where the film was marched in time so far
};

}  // namespace

struct FilmBearingSolver::Workspace {
  Workspace(SharedFilmBearing film_bearing, const FilmBearingOptions& solver_options)
      : shared(std::move(film_bearing)), options(solver_options), newton(shared, solver_options.newton) {}

  FilmReport solve(const OperatingPoint& to, const FilmEquations& equations, BearingState& state,
                   bool stays_near = false);
  FilmReport solve_on_branch(const OperatingPoint& to, BearingState& state);
  FilmReport settle(const OperatingPoint& to, BearingState& state);
  void jump(BranchEnd& end, BearingState& state, FilmReport& total);
  [[nodiscard]] double steps_between(const OperatingPoint& from, const OperatingPoint& to) const;

  SharedFilmBearing shared;
  const FilmBearing& bearing{*shared};
  FilmBearingOptions options;
  FilmNewton newton;
};

FilmReport FilmBearingSolver::Workspace::solve(const OperatingPoint& to, const FilmEquations& equations,
                                               BearingState& state, bool stays_near) {
  if (options.keep_going && !options.keep_going()) return {.status = FilmStatus::interrupted};
  // A step in time is but a guess of the next.
  const double tolerance =
      equations.front().squeeze_rate > 0.0 ? options.marching_tolerance : options.newton.step_tolerance;
  const NewtonTarget target{journal_law(to, bearing.scales), to.speed, to.opening};
  return newton.solve(target, equations, {.tolerance = tolerance, .stays_near = stays_near}, state);
}

/// solve() from one state to the next, under a load on the same branch: a state that lies off the tangent's prediction
/// by more than curvature and contacts explain is not accepted, as Newton's method has reached another branch.
FilmReport FilmBearingSolver::Workspace::solve_on_branch(const OperatingPoint& to, BearingState& state) {
  const bool by_load = to.control == OperatingPoint::Control::load;
  BearingState found = state;
  FilmReport report = solve(to, film_equations(bearing, to.speed), found, by_load);
  if (report.status != FilmStatus::converged) return report;
  if (by_load &&
      report.departure > std::max(options.largest_departure * report.predicted_change, options.resolved_departure)) {
    report.status = FilmStatus::not_converged;
    return report;
  }
  state = std::move(found);
  return report;
}

/// From the last state of a branch to where the film comes to rest in time behind the end. Under a load, if it rests
/// nowhere, to the state that Newton's method reaches in the shortest step that it converges in. It counts as a jump
/// unless it is but a corner of the branch, at which Newton's method failed.
void FilmBearingSolver::Workspace::jump(BranchEnd& end, BearingState& state, FilmReport& total) {
  const BearingState last = state;
  const double begin = end.reached;
  const auto behind = [&](double leap) {
    end.reached = std::min(1.0, begin + std::min(leap, end.longest));
    return between(end.from, end.to, end.reached);
  };
  const bool by_load = end.to.control == OperatingPoint::Control::load;
  const bool marches_first = end.comes_to_rest || !by_load;
  if (marches_first) {
    total += settle(behind(end.leap), state);
    end.comes_to_rest = total.status == FilmStatus::converged;
  }
  FilmStatus rested = total.status;
  if (rested == FilmStatus::interrupted) return;
  for (double leap = end.leap; total.status != FilmStatus::converged && by_load; leap *= step_growth_off_branch) {
    const OperatingPoint there = behind(leap);
    total += solve(there, film_equations(bearing, there.speed), state);
    if (total.status == FilmStatus::interrupted) return;
    if (leap >= end.longest) break;
  }
  if (total.status != FilmStatus::converged && !marches_first) {
    total += settle(behind(end.leap), state);
    rested = total.status;
    if (rested == FilmStatus::interrupted) return;
  }
  if (total.status == FilmStatus::converged) {
    if (newton.distance(last, state) > options.resolved_departure) ++total.jumps;
  } else {
    total.status = rested == FilmStatus::not_converged ? FilmStatus::fold : rested;
  }
}

FilmReport FilmBearingSolver::Workspace::settle(const OperatingPoint& to, BearingState& state) {
  const double T0 = bearing.scales.squeeze_time();
  const double first = options.first_time_step * T0;
  FilmEquations equations = film_equations(bearing, to.speed);
  BearingState moving = state;
  FilmReport total;
  double dt = first;
  double last_change = std::numeric_limits<double>::infinity();
  for (int steps = 0;; ++steps) {
    if (steps == options.max_time_steps) {
      total.status = FilmStatus::not_converged;
      return total;
    }
    squeeze(bearing, T0 / dt, film_content(moving.film), equations);
    const BearingState before = moving;
    total += solve(to, equations, moving);
    if (total.status == FilmStatus::interrupted) return total;
    if (total.status != FilmStatus::converged) {
      dt *= 0.25;
      if (dt < smallest_time_step * first) return total;
      continue;
    }
    const double change = newton.distance(before, moving);
    if (change > largest_change_ratio * last_change && newton.distance(state, before) < near_start &&
        dt > shortest_bounded_step * first) {
      moving = before;
      dt *= 0.25;
      continue;
    }
    // A drift that grows with the step is no rest: the march passes by the end of a branch.
    if (dt > options.last_time_step && change < options.resting_change && change <= last_change) {
      BearingState rested = moving;
      total += solve(to, film_equations(bearing, to.speed), rested);
      if (total.status == FilmStatus::converged) state = std::move(rested);
      if (total.status != FilmStatus::not_converged) return total;
    }
    last_change = std::max(change, options.marching_tolerance);
    dt *= options.time_growth;
  }
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

FilmBearingSolver::FilmBearingSolver(SharedFilmBearing bearing, const FilmBearingOptions& options)
    : workspace_(std::make_unique<Workspace>(std::move(bearing), options)) {}

FilmBearingSolver::FilmBearingSolver(FilmBearing bearing, const FilmBearingOptions& options)
    : FilmBearingSolver(std::make_shared<const FilmBearing>(std::move(bearing)), options) {}

FilmBearingSolver::~FilmBearingSolver() = default;

const FilmBearing& FilmBearingSolver::bearing() const {
  return workspace_->bearing;
}

FilmReport FilmBearingSolver::solve(const OperatingPoint& to, BearingState& state) {
  state.slip_origin = state.contacts.x;
  return workspace_->solve(to, film_equations(workspace_->bearing, to.speed), state);
}

FilmReport FilmBearingSolver::settle(const OperatingPoint& to, BearingState& state) {
  state.slip_origin = state.contacts.x;
  return workspace_->settle(to, state);
}

FilmReport FilmBearingSolver::cold_start(const Eigen::Vector2d& position, double speed, BearingState& state,
                                         double opening) {
  BearingState start = resting(workspace_->bearing, position, speed, opening);
  const FilmReport report = workspace_->settle(OperatingPoint::held_at(position, speed, opening), start);
  if (report.status == FilmStatus::converged) state = std::move(start);
  return report;
}

std::optional<SlowMotion> FilmBearingSolver::slow_motion(const BearingState& state, bool stuck) {
  return workspace_->newton.slow_motion(state, stuck);
}

std::optional<Eigen::Matrix2d> FilmBearingSolver::stiffness(const BearingState& state, bool stuck) {
  const std::optional<SlowMotion> motion = slow_motion(state, stuck);
  return motion ? std::optional(motion->stiffness) : std::nullopt;
}

std::optional<std::vector<Eigen::Matrix2cd>> FilmBearingSolver::impedances(
    const BearingState& state, const std::vector<std::complex<double>>& rates, bool stuck) {
  return workspace_->newton.impedances(state, rates, stuck);
}

FilmReport FilmBearingSolver::follow(const OperatingPoint& to, BearingState& state) {
  state.slip_origin = state.contacts.x;
  Workspace& w = *workspace_;
  const bool by_load = to.control == OperatingPoint::Control::load;
  const OperatingPoint from{to.control, by_load ? film_force(w.bearing, state.film.pressure) : state.position,
                            state.speed, state.opening};
  const double steps = w.steps_between(from, to);
  const double shortest = (by_load ? w.options.smallest_load_fraction : w.options.smallest_fraction) / steps;
  BranchEnd end{.from = from, .to = to, .longest = 1.0 / steps, .leap = shortest};
  FilmReport total;
  int ends = 0;
  double step = end.longest;
  while (end.reached < 1.0) {
    const double next = std::min(1.0, end.reached + step);
    const FilmReport report = w.solve_on_branch(between(from, to, next), state);
    total += report;
    if (report.status == FilmStatus::interrupted) return total;
    if (report.status == FilmStatus::converged) {
      end.reached = next;
      end.leap = shortest;
      if (report.iterations < easy_iterations) step *= w.options.time_growth;
      continue;
    }
    step *= 0.5;
    if (step >= end.leap) continue;
    if (report.status != FilmStatus::not_converged) return total;
    // The branch ends: no state near the last one goes on.
    if (ends++ == w.options.max_ends) {
      total.status = FilmStatus::fold;
      return total;
    }
    w.jump(end, state, total);
    if (total.status != FilmStatus::converged) return total;
    // Where the next step fails at once the end has not been left yet.
    end.leap = std::min(step_growth_off_branch * end.leap, end.longest);
    step = end.leap;
  }
  return total;
}

}  // namespace bumpfoil
