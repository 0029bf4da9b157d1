#include "support/uzawa_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "support/reference_cycles.hpp"

namespace bumpfoil {

UzawaDeviation compare_uzawa(Case input, const CycleResult& exact, const UzawaParameters& parameters) {
  input.solver.name = SolverName::uzawa;
  input.solver.uzawa = parameters;
  const CycleResult result = run_cycles(input);
  UzawaDeviation deviation;
  std::size_t increments = 0;
  for (std::size_t i = 0; i < result.cycles.size(); ++i) {
    const Cycle& cycle = result.cycles[i];
    const Cycle& reference = exact.cycles[i];
    increments += cycle.increments.size();
    deviation.solves_per_increment += cycle.cost.iterations;
    deviation.updates_per_increment += cycle.cost.outer_iterations;
    deviation.halvings += cycle.substeps;
    if (!cycle.converged()) {
      ++deviation.failures;
      continue;
    }
    const double force = reference.turning_point->max_force;
    deviation.max_force = std::max(deviation.max_force, std::abs(cycle.turning_point->max_force / force - 1.0));
    // Without friction both loops are round-off; the reference is then the work of the push.
    const double work = reference.turns.front().work;
    const double energy = *reference.loop_energy > 1e-9 * work ? *reference.loop_energy : work;
    deviation.loop_energy =
        std::max(deviation.loop_energy, std::abs(*cycle.loop_energy - *reference.loop_energy) / energy);
  }
  deviation.solves_per_increment /= static_cast<double>(increments);
  deviation.updates_per_increment /= static_cast<double>(increments);
  return deviation;
}

UzawaDeviation worst(const UzawaDeviation& a, const UzawaDeviation& b) {
  return {.max_force = std::max(a.max_force, b.max_force),
          .loop_energy = std::max(a.loop_energy, b.loop_energy),
          .solves_per_increment = std::max(a.solves_per_increment, b.solves_per_increment),
          .updates_per_increment = std::max(a.updates_per_increment, b.updates_per_increment),
          .halvings = a.halvings + b.halvings,
          .failures = a.failures + b.failures};
}

Case uzawa_study_case() {
  return case_with_given_constants();
}

Case scattered_uzawa_study_case() {
  const auto& cycles = reference_cycles();
  const auto scattered = std::find_if(cycles.begin(), cycles.end(), [](const ReferenceCycle& cycle) {
    return !cycle.input.bump_foil.height_errors.empty();
  });
  Case input = case_with_given_constants();
  input.bump_foil.height_errors = scattered->input.bump_foil.height_errors;
  return input;
}

}  // namespace bumpfoil
