#include "bumpfoil/experiments/experiments.hpp"

#include <algorithm>

#include "bumpfoil/core/assert.hpp"
#include "experiments/registry.hpp"

namespace bumpfoil {

#define BUMPFOIL_DECLARE(name) ExperimentInfo name##_experiment();
BUMPFOIL_EXPERIMENTS(BUMPFOIL_DECLARE)
#undef BUMPFOIL_DECLARE

const std::vector<ExperimentInfo>& experiments() {
#define BUMPFOIL_CALL(name) name##_experiment(),
  static const std::vector<ExperimentInfo> all{BUMPFOIL_EXPERIMENTS(BUMPFOIL_CALL)};
#undef BUMPFOIL_CALL
  return all;
}

const ExperimentInfo& experiment_named(std::string_view name) {
  const auto found = std::find_if(experiments().begin(), experiments().end(),
                                  [&](const ExperimentInfo& experiment) { return experiment.name == name; });
  BUMPFOIL_ASSERT(found != experiments().end());
  return *found;
}

std::vector<Fault> faults_of_run(const std::string& command, const Case& input) {
  const auto found = std::find_if(experiments().begin(), experiments().end(),
                                  [&](const ExperimentInfo& experiment) { return experiment.name == command; });
  return found == experiments().end() || !found->check ? std::vector<Fault>{} : found->check(input);
}

}  // namespace bumpfoil
