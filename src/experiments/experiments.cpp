#include "bumpfoil/experiments/experiments.hpp"

#include <algorithm>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

// Each in its folder.
ExperimentInfo cycle_experiment();
ExperimentInfo strip_experiment();
ExperimentInfo path_experiment();
ExperimentInfo vibration_experiment();
ExperimentInfo equilibrium_experiment();
ExperimentInfo film_experiment();

const std::vector<ExperimentInfo>& experiments() {
  static const std::vector<ExperimentInfo> all{cycle_experiment(),     strip_experiment(),       path_experiment(),
                                               vibration_experiment(), equilibrium_experiment(), film_experiment()};
  return all;
}

const ExperimentInfo& experiment_named(std::string_view name) {
  const auto found = std::find_if(experiments().begin(), experiments().end(),
                                  [&](const ExperimentInfo& experiment) { return experiment.name == name; });
  BUMPFOIL_ASSERT(found != experiments().end());
  return *found;
}

}  // namespace bumpfoil
