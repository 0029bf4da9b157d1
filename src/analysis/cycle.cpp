#include "bumpfoil/analysis/cycle.hpp"

#include <algorithm>
#include <utility>

#include "analysis/cycle_series.hpp"
#include "analysis/former_cycle.hpp"
#include "analysis/run_each_cycle.hpp"
#include "analysis/settling.hpp"

namespace bumpfoil {

bool CycleResult::converged() const {
  return cycles.size() >= due &&
         std::all_of(cycles.begin(), cycles.end(), [](const Cycle& cycle) { return cycle.converged(); });
}

CycleRunner::CycleRunner(SharedFoils foils, const SolverSettings& settings) : stepper_(std::move(foils), settings) {}

Cycle CycleRunner::run(double direction, const CycleSettings& settings, Recording recording,
                       const ProgressCallback& progress, const Excitation& centre) {
  const Foils& foils = stepper_.foils();
  const CycleCourse course{.direction = direction,
                           .amplitude = settings.amplitude,
                           .preload = settings.preload,
                           .swings = settings.swings(),
                           .steps = settings.steps,
                           .reach = foils.clearance + foils.rise};
  std::vector<Clearance> clearances;
  for (const double force : settings.clearance_forces) clearances.push_back({force, {}});
  CycleSeries series(stepper_, course, centre, step_);
  return series.until_settled(settings.cycles, recording, progress, clearances);
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
