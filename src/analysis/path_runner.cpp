#include "bumpfoil/analysis/path_runner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/analysis/cycle_quantities.hpp"
#include "bumpfoil/analysis/energy.hpp"
#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

/// A load is met to this part of max(load, 1 N): well above the residual of each solver.
constexpr double exact_load_tolerance = 1e-9;
constexpr double regularised_load_tolerance = 1e-5;
/// Many more than a function with a bracket needs that is linear, or under large displacements smooth, in pieces.
constexpr int most_tries = 100;
/// The first step towards a load where nothing is touched yet, as part of the reach.
constexpr double first_part = 1e-3;

}  // namespace

PathRunner::PathRunner(const FoilModel& model, const SolverSettings& settings)
    : model_(model), solver_(settings, model.problem) {}

bool PathRunner::assemble(const Eigen::Vector2d& position) {
  const ContactState unstressed = ContactState::unstressed(model_.problem);
  Stage next;
  next.position = position;
  next.loading = loading_at(model_, position);
  next.report.solve = solver_.assemble(next.loading, unstressed, next.state);
  next.begin_of_part = unstressed.x;
  if (!next.report.solve.converged) return false;
  path_done_ = 1.0;
  assembly_dissipation_ = friction_dissipation(model_.problem, next.state.normal_force, unstressed.x, next.state.x);
  now_ = std::move(next);
  return true;
}

void PathRunner::set_out(const Eigen::Vector2d& end) {
  path_start_ = now_.position;
  path_end_ = end;
  path_done_ = 0.0;
  solver_.set_out(now_.loading, loading_at(model_, end), now_.state);
}

bool PathRunner::try_increment(double fraction) {
  BUMPFOIL_ASSERT(fraction > path_done_ && fraction <= 1.0);
  next_ = now_;
  next_.events.clear();
  next_.position = (1.0 - fraction) * path_start_ + fraction * path_end_;
  next_.loading = loading_at(model_, next_.position);
  const auto visit = [this](const ContactState& begin, const ContactState& end) {
    next_.begin_of_part = begin.x;
    next_.work += gap_work(model_.problem, begin, end);
    // Forces vary linearly from event to event; an increment carries the friction of its end throughout.
    const double weight = solver_.follows_events() ? 0.5 : 0.0;
    next_.dissipation += friction_dissipation(
        model_.problem, weight * begin.normal_force + (1.0 - weight) * end.normal_force, begin.x, end.x);
  };
  next_.report = solver_.advance_to(fraction, next_.state, visit, next_.events);
  next_.dissipation += next_.report.jump_dissipation;
  for (ContactEvent& event : next_.events) event.fraction = (event.fraction - path_done_) / (fraction - path_done_);
  path_done_ = next_.report.solve.converged ? fraction : 1.0;
  return next_.report.solve.converged;
}

bool PathRunner::advance_to(double fraction) {
  if (!try_increment(fraction)) return false;
  std::swap(now_, next_);
  return true;
}

bool PathRunner::move_to(const Eigen::Vector2d& position) {
  set_out(position);
  return advance_to(1.0);
}

bool PathRunner::load_to(const Eigen::Vector2d& normal, double load, double reach) {
  const auto force_of = [&](const Stage& stage) { return holding_force(model_, stage.state.normal_force).dot(normal); };
  // A load as small as the tolerance must still tell a plate that carries it from one that has lifted.
  const double tolerance = std::min(
      0.5 * load, std::max(load, 1.0) * (solver_.is_exact() ? exact_load_tolerance : regularised_load_tolerance));
  const Eigen::Vector2d start = now_.position;
  double below = -HUGE_VAL;  // steps that end with less load, and with more
  double above = HUGE_VAL;
  IncrementReport total;
  total.solve.converged = true;

  Stage tried = now_;  // standing still
  tried.events.clear();
  tried.begin_of_part = now_.state.x;
  double step = 0.0;
  for (int i = 0; i < most_tries; ++i) {
    const double missing = load - force_of(tried);
    if (std::abs(missing) <= tolerance) {
      tried.report = total;
      now_ = std::move(tried);
      return true;
    }
    (missing > 0.0 ? below : above) = step;

    const TangentStiffnesses tangent = tangent_stiffnesses(model_, tried.state, normal);
    // The first try turns round, or goes on as before.
    const double slope = (i == 0 && missing < 0.0 ? tangent.unloading : tangent.loading).value_or(0.0);
    const double newton = slope > 0.0 ? step + missing / slope : HUGE_VAL;
    const double further = std::max(std::abs(step), first_part * reach);
    if (newton > below && newton < above) {
      step = newton;
    } else if (std::isinf(above)) {
      step = below + further;
    } else if (std::isinf(below)) {
      step = above - further;
    } else {
      step = 0.5 * (below + above);
    }
    const double most = reach - start.dot(normal);
    if (step > most) {
      if (below >= most) return false;
      step = most;
    }
    set_out(start + step * normal);
    if (!try_increment(1.0)) return false;
    total.solve += next_.report.solve;
    total.substeps += next_.report.substeps;
    std::swap(tried, next_);
  }
  return false;
}

void PathRunner::reset_books() {
  now_.begin_of_part = now_.state.x;
  now_.work = 0.0;
  now_.dissipation = 0.0;
  now_.report = {};
  now_.report.solve.converged = true;
}

Increment PathRunner::record(const Eigen::Vector2d& normal) const {
  Increment next = record_increment(model_, now_.position, normal, now_.loading, now_.begin_of_part, now_.state);
  next.displacement = now_.position.dot(normal);
  next.work = now_.work;
  next.dissipated_energy = now_.dissipation;
  next.solve = now_.report.solve;
  next.substeps = now_.report.substeps;
  return next;
}

}  // namespace bumpfoil
