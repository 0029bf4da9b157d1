#include "bumpfoil/experiments/cycle/cycle.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "bumpfoil/experiments/build.hpp"
#include "experiments/cycle/cycle_run.hpp"
#include "experiments/cycle/cycle_series.hpp"
#include "experiments/cycle/run_each_cycle.hpp"

namespace bumpfoil {

bool CycleResult::converged() const {
  return cycles.size() >= due &&
         std::all_of(cycles.begin(), cycles.end(), [](const Cycle& cycle) { return cycle.converged(); });
}

CycleRunner::CycleRunner(SharedBearing foils, const SolverSettings& settings)
    : foils_(std::move(foils)), settings_(settings) {}

void CycleRunner::set_foils(SharedBearing foils) {
  for (std::optional<FoilStepper>* stepper : {&exact_, &fast_}) {
    if (*stepper && !(*stepper)->set_foils(foils)) stepper->reset();
  }
  foils_ = std::move(foils);
}

Cycle CycleRunner::run(double direction, const CycleSettings& settings, Recording recording,
                       const ProgressCallback& progress, const Excitation& centre) {
  std::vector<Clearance> clearances;
  for (const double force : settings.clearance_forces) clearances.push_back({force, {}});
  const auto run_with = [&](std::optional<FoilStepper>& stepper, Rates rates, int steps) {
    if (!stepper) stepper = make_stepper(foils_, settings_, rates);
    const CycleCourse course{.direction = direction,
                             .amplitude = settings.amplitude,
                             .preload = settings.preload,
                             .fully_reversed = settings.is_fully_reversed(),
                             .steps = steps,
                             .reach = foils_->clearance + foils_->rise};
    CycleSeries series(*stepper, course, centre, step_);
    return series.until_settled(settings.cycles, recording, progress, clearances);
  };
  const bool needs_no_steps = recording == Recording::quantities && settings_.chosen() == SolverName::events &&
                              !settings.preload && settings.amplitude.control == Control::displacement;
  if (needs_no_steps) {
    Cycle cycle = run_with(fast_, Rates::by_tableau, 1);
    const bool came_through = cycle.converged() && cycle.substeps == 0;
    if (came_through || cycle.status == Status::interrupted) return cycle;
  }
  return run_with(exact_, Rates::by_solves, settings.steps);
}

CycleRun present_cycle_run(const Case& input) {
  const auto runner = std::make_shared<CycleRunner>(make_bearing_foils(input, {"cycle"}), input.solver);
  return [runner, &input](double direction, const ProgressCallback& progress) {
    return runner->run(direction, input.settings.get<CycleSettings>(), Recording::everything, progress);
  };
}

CycleResult run_cycles(const Case& input, const ProgressCallback& progress) {
  const CycleRun run = make_cycle_run(input);
  const std::vector<double>& directions = input.settings.get<CycleSettings>().directions;
  return run_each_cycle(
      Experiment::cycle, input, std::ssize(directions), progress,
      [&](std::size_t i, const ProgressCallback& progress_of_cycle) { return run(directions[i], progress_of_cycle); });
}

}  // namespace bumpfoil
