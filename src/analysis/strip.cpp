#include "bumpfoil/analysis/strip.hpp"

#include <chrono>
#include <utility>

#include "analysis/cycle_recorder.hpp"
#include "analysis/program_runner.hpp"
#include "analysis/run_each_cycle.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

const Line towards_base{.base = Eigen::Vector2d::Zero(), .direction = Eigen::Vector2d::UnitX()};

Control control_of(const PlateTarget& target) {
  return target.control == PlateControl::load ? Control::load : Control::position;
}

/// The state in which a cycle ended, as the start of the next: nothing happened on the way there.
void start_anew(Step& step) {
  FoilState state = std::move(step.state);
  step = Step{};
  step.state = std::move(state);
  step.state.slip_origin = step.state.contacts.x;
}

/// Assembles the strip and brings the plate to its preload, if there is one: `step` is how the start of the first cycle
/// was reached.
/// @return what the assembly dissipated, J
double approach(FoilStepper& stepper, const StripSettings& strip, double reach, Step& step) {
  stepper.assemble({}, step);
  const double assembly_dissipation = step.state.dissipated_energy;
  if (!strip.preload || !step.converged()) return assembly_dissipation;
  FoilState state = step.state;
  const Program program{{.branch = Branch::loading,
                         .control = control_of(*strip.preload),
                         .line = towards_base,
                         .begin = 0.0,
                         .end = strip.preload->value,
                         .steps = strip.steps}};
  for (ProgramRunner runner(stepper, program, reach, state); runner.has_next(); runner.commit(step)) {
    runner.try_next(step);
    if (!step.converged()) return assembly_dissipation;
  }
  step.state = std::move(state);
  start_anew(step);
  return assembly_dissipation;
}

/// What legs are counted from: the position of the plate, or its load.
double origin_of(const StripSettings& strip, const Step& start) {
  if (!strip.preload) return 0.0;
  if (control_of(strip.amplitude) == Control::load) return strip.preload->value;
  return start.state.excitation.position.x();
}

}  // namespace

CycleResult run_strip(const Case& input, const ProgressCallback& progress) {
  const SharedFoils foils = make_strip_foils(input);
  const StripSettings& strip = *input.strip;
  const Control control = control_of(strip.amplitude);
  FoilStepper stepper(foils, input.solver);
  CyclePlan plan{.program = {}, .reach = nominal_bump(input.bump_foil).rise};  // bumps are flat there
  Step step;
  return run_each_cycle(
      Experiment::strip, input, strip.cycles, progress, [&](std::size_t i, const ProgressCallback& progress_of_cycle) {
        const auto begin = std::chrono::steady_clock::now();
        Cycle cycle;
        cycle.course = strip.preload ? Course::swing : Course::push;
        cycle.amplitude = strip.amplitude.value;
        cycle.steps = strip.steps;
        if (i == 0) {
          cycle.assembly_dissipation = approach(stepper, strip, plan.reach, step);
          const auto make_program = strip.preload ? swing : push_and_pull;
          plan.program =
              make_program(control, towards_base, origin_of(strip, step), strip.amplitude.value, strip.steps);
        } else {
          start_anew(step);
        }
        cycle = run_cycle(stepper, plan, std::move(cycle), step, progress_of_cycle);
        cycle.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return cycle;
      });
}

}  // namespace bumpfoil
