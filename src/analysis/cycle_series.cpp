#include "analysis/cycle_series.hpp"

#include <chrono>
#include <utility>

#include "analysis/program_runner.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {

/// The state in which a cycle ended, or the preload was reached, as the start of the next: nothing happened on the way
/// there.
void CycleSeries::start_anew() {
  FoilState state = std::move(step_.state);
  step_ = Step{};
  step_.state = std::move(state);
  step_.state.slip_origin = step_.state.contacts.x;
}

/// `step` is how the start of the first cycle was reached.
/// @return what the assembly dissipated, J
double CycleSeries::assemble_and_approach() {
  stepper_.assemble(centre_, step_);
  const double assembly_dissipation = step_.state.dissipated_energy;
  if (!course_.preload || !step_.converged()) return assembly_dissipation;
  const auto& [control, value] = *course_.preload;
  const Eigen::Vector2d from = control == Control::displacement ? centre_.position : Eigen::Vector2d::Zero();
  const Eigen::Vector2d way = value - from;
  if (way.isZero(0.0)) return assembly_dissipation;
  FoilState state = step_.state;
  const Program lead_in{{.branch = Branch::loading,
                         .control = control,
                         .line = {.base = from, .direction = way.normalized()},
                         .begin = 0.0,
                         .end = way.norm(),
                         .steps = course_.steps}};
  for (ProgramRunner runner(stepper_, lead_in, course_.reach, state); runner.has_next(); runner.commit(step_)) {
    runner.try_next(step_);
    if (!step_.converged()) return assembly_dissipation;
  }
  step_.state = std::move(state);
  start_anew();
  return assembly_dissipation;
}

/// Legs of a cycle from where the foils are.
Program CycleSeries::program() const {
  const auto make_program = course_.swings ? swing : push_and_pull;
  Line line{.base = centre_.position, .direction = unit_vector(course_.direction)};
  double origin = 0.0;
  if (course_.amplitude.control == Control::load) {
    line.base = course_.preload ? course_.preload->value : Eigen::Vector2d(0.0, 0.0);
  } else if (course_.preload) {
    const Eigen::Vector2d& position = step_.state.excitation.position;
    origin = position.dot(line.direction);
    line.base = position - origin * line.direction;
  }
  return make_program(course_.amplitude.control, line, origin, course_.amplitude.value, course_.steps);
}

Cycle CycleSeries::next(Recording recording, const ProgressCallback& progress, std::vector<Clearance> clearances) {
  const auto begin = std::chrono::steady_clock::now();
  Cycle cycle;
  cycle.direction = course_.direction;
  cycle.course = course_.swings ? Course::swing : Course::push;
  cycle.amplitude = course_.amplitude.value;
  cycle.steps = course_.steps;
  cycle.clearances = std::move(clearances);
  if (program_.empty()) {
    cycle.assembly_dissipation = assemble_and_approach();
    program_ = program();
  } else {
    start_anew();
  }
  const CyclePlan plan{.program = program_, .reach = course_.reach, .recording = recording};
  cycle = run_cycle(stepper_, plan, std::move(cycle), step_, progress);
  cycle.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return cycle;
}

}  // namespace bumpfoil
