#include "bumpfoil/ensemble/running_sample.hpp"

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {
namespace {

/// What is told of a bearing that cannot be built.
EquilibriumResult not_run(const EquilibriumSettings& equilibrium) {
  EquilibriumResult result;
  for (const OperatingPoint& point : asked_points(equilibrium)) {
    RunningState& state = result.states.emplace_back();
    state.path = equilibrium.path;
    state.asked = point;
    state.report.status = FilmStatus::not_physical;
  }
  return result;
}

}  // namespace

EquilibriumResult run_running_sample(const Case& sampled, const std::function<bool(double)>& progress) {
  try {
    return run_equilibrium(sampled, {}, progress);
  } catch (const Error&) {
    return not_run(*sampled.equilibrium);
  }
}

}  // namespace bumpfoil
