#include "bumpfoil/analysis/cycle.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/loop_runner.hpp"
#include "analysis/run_loops.hpp"
#include "bumpfoil/analysis/cycle_quantities.hpp"
#include "bumpfoil/analysis/former_cycle.hpp"
#include "bumpfoil/analysis/path_runner.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
double Cycle::initial_journal_load() const {
  return increments.empty() ? 0.0 : increments.front().journal_top.normal_force.sum();
}

double Cycle::max_residual() const {
  double largest = 0.0;
  for (const Increment& increment : increments) {
    if (std::isnan(largest)) break;  // an unknown residual is no small one
    if (!(increment.residuals.equilibrium <= largest)) largest = increment.residuals.equilibrium;
  }
  return largest;
}

SolveReport Cycle::total() const {
  SolveReport sum;
  for (const Increment& increment : increments) sum += increment.solve;
  return sum;
}

int Cycle::substeps() const {
  int sum = 0;
  for (const Increment& increment : increments) sum += increment.substeps;
  return sum;
}

bool CycleResult::converged() const {
  return std::all_of(cycles.begin(), cycles.end(), [](const Cycle& cycle) { return cycle.converged; });
}

CycleResult run_cycles(const Case& input, const ProgressCallback& progress) {
  if (input.bump_foil.model == BumpFoilModel::former) return run_former_cycles(input, progress);
  const FoilModel model = make_bearing_model(input);
  PathRunner path(model, input.solver);
  const CycleSettings& settings = input.cycle;
  const auto make_runner = [&](std::size_t i) {
    const auto assemble = [](PathRunner& runner) {
      return runner.assemble(Eigen::Vector2d::Zero()) ? std::optional(0.0) : std::nullopt;
    };
    Cycle cycle;
    cycle.direction = settings.directions[i];
    cycle.amplitude = settings.amplitude;
    cycle.steps = settings.steps;
    return LoopRunner(path,
                      {.normal = unit_vector(cycle.direction),
                       .legs = push_and_pull(settings.amplitude, settings.steps),
                       .begin = assemble,
                       .assembles = true},
                      cycle);
  };
  CycleResult result = run_loops(Experiment::cycle, input, std::ssize(settings.directions), progress, make_runner);
  for (Cycle& cycle : result.cycles) {
    if (cycle.increments.empty()) continue;
    cycle.first_contact = first_contact_displacement(
        model.clearance, model.normals, cycle.increments.front().top_displacement, unit_vector(cycle.direction));
  }
  return result;
}

}  // namespace bumpfoil
