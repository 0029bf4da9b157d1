#include "bumpfoil/analysis/cycle.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "analysis/cycle_recorder.hpp"
#include "analysis/former_cycle.hpp"
#include "analysis/run_each_cycle.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {

bool CycleResult::converged() const {
  return std::all_of(cycles.begin(), cycles.end(), [](const Cycle& cycle) { return cycle.converged(); });
}

CycleRunner::CycleRunner(SharedFoils foils, const SolverSettings& settings) : stepper_(std::move(foils), settings) {}

Cycle CycleRunner::run(double direction, const CycleSettings& settings, Recording recording,
                       const ProgressCallback& progress, const Excitation& centre) {
  const auto begin = std::chrono::steady_clock::now();
  const Eigen::Vector2d normal = unit_vector(direction);
  Cycle cycle;
  cycle.direction = direction;
  cycle.amplitude = settings.amplitude;
  cycle.steps = settings.steps;
  for (const double force : settings.clearance_forces) cycle.clearances.push_back({force, {}});
  stepper_.assemble(centre, step_);
  if (step_.converged()) {
    cycle.assembly_dissipation = step_.state.dissipated_energy;
  }
  const CyclePlan plan{.program = push_and_pull(Control::position, {.base = centre.position, .direction = normal}, 0.0,
                                                settings.amplitude, settings.steps),
                       .recording = recording};
  cycle = run_cycle(stepper_, plan, std::move(cycle), step_, progress);
  cycle.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return cycle;
}

CycleResult run_cycles(const Case& input, const ProgressCallback& progress) {
  if (input.bump_foil.model == BumpFoilModel::former) return run_former_cycles(input, progress);
  CycleRunner runner(make_bearing_foils(input), input.solver);
  const CycleSettings& settings = input.cycle;
  return run_each_cycle(Experiment::cycle, input, std::ssize(settings.directions), progress,
                        [&](std::size_t i, const ProgressCallback& progress_of_cycle) {
                          return runner.run(settings.directions[i], settings, Recording::everything, progress_of_cycle);
                        });
}

}  // namespace bumpfoil
