#include "experiments/cycle/cycle_series.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "bearing/settling.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/motion/march.hpp"

namespace bumpfoil {

namespace {

/// Uses the end of a cycle, or the preload, as the start of the next, with an empty history.
void start_anew(Step& step) {
  BearingState state = std::move(step.state);
  step = Step{};
  step.state = std::move(state);
  step.state.begin_increment();
}

/// Adds the totals of previous cycles to those of a cycle.
void follow_on(const Cycle& before, Cycle& cycle) {
  cycle.assembly_dissipation = before.assembly_dissipation;
  cycle.loop_energies.insert(cycle.loop_energies.begin(), before.loop_energies.begin(), before.loop_energies.end());
  cycle.settled = is_settled(cycle.loop_energies);
  cycle.cost += before.cost;
  cycle.substeps += before.substeps;
  cycle.max_residual = std::max(cycle.max_residual, before.max_residual);
  cycle.wall_time += before.wall_time;
}

}  // namespace

double approach(FoilStepper& stepper, const Approach& plan, Step& step) {
  stepper.assemble(plan.centre, step);
  const double assembly_dissipation = step.state.dissipated_energy;
  if (!plan.preload || !step.converged()) return assembly_dissipation;
  const auto& [control, value] = *plan.preload;
  const Eigen::Vector2d from = control == Control::displacement ? plan.centre.position : Eigen::Vector2d::Zero();
  const Eigen::Vector2d distance = value - from;
  if (distance.isZero(0.0)) return assembly_dissipation;
  BearingState state = step.state;
  const Program lead_in{{.branch = Branch::loading,
                         .control = control,
                         .line = {.base = from, .direction = distance.normalized()},
                         .begin = 0.0,
                         .end = distance.norm(),
                         .steps = plan.steps}};
  const bool there = march(stepper_of(stepper, largest_place(lead_in), plan.reach), schedule_of(lead_in), state, step,
                           [](const Passage& at) { return at.step.converged() ? Verdict::go_on : Verdict::refuse; });
  if (!there) return assembly_dissipation;
  step.state = std::move(state);
  start_anew(step);
  return assembly_dissipation;
}

/// Legs of a cycle from the current state of the foils.
Program CycleSeries::program() const {
  const auto make_program = course_.fully_reversed ? fully_reversed_cycle : one_sided_cycle;
  Line line{.base = centre_ ? centre_->position : Eigen::Vector2d(0.0, 0.0),
            .direction = unit_vector(course_.direction)};
  double origin = 0.0;
  if (course_.amplitude.control == Control::load) {
    line.base = course_.preload ? course_.preload->value : Eigen::Vector2d(0.0, 0.0);
  } else if (course_.preload) {
    const Eigen::Vector2d& position = step_.state.position;
    origin = position.dot(line.direction);
    line.base = position - origin * line.direction;
  }
  return make_program(course_.amplitude.control, line, origin, course_.amplitude.value, course_.steps);
}

Cycle CycleSeries::next(Recording recording, const ProgressCallback& progress, std::vector<Clearance> clearances) {
  const auto begin = std::chrono::steady_clock::now();
  Cycle cycle;
  cycle.direction = course_.direction;
  cycle.course = course_.fully_reversed ? Course::fully_reversed : Course::one_sided;
  cycle.amplitude = course_.amplitude.value;
  cycle.steps = course_.steps;
  cycle.clearances = std::move(clearances);
  if (program_.empty()) {
    if (centre_) {
      const Approach plan{
          .centre = *centre_, .preload = course_.preload, .steps = course_.steps, .reach = course_.reach};
      cycle.assembly_dissipation = approach(stepper_, plan, step_);
    }
    program_ = program();
  } else {
    start_anew(step_);
  }
  const CyclePlan plan{.program = program_, .reach = course_.reach, .recording = recording};
  cycle = run_cycle(stepper_, plan, std::move(cycle), step_, progress);
  cycle.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return cycle;
}

Cycle CycleSeries::until_settled(int most, Recording recording, const ProgressCallback& progress,
                                 const std::vector<Clearance>& clearances) {
  Cycle cycle;
  for (int i = 0; i < most && cycle.converged() && !cycle.settled; ++i) {
    const auto progress_of_cycle = [&](double fraction) { return !progress || progress((i + fraction) / most); };
    Cycle next_cycle = next(recording, progress_of_cycle, clearances);
    if (next_cycle.loop_energy) next_cycle.loop_energies = {*next_cycle.loop_energy};
    if (i > 0) follow_on(cycle, next_cycle);
    cycle = std::move(next_cycle);
  }
  return cycle;
}

}  // namespace bumpfoil
