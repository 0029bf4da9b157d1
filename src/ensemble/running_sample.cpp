#include "bumpfoil/ensemble/running_sample.hpp"

#include "bumpfoil/analysis/film_limits.hpp"
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

EquilibriumResult run_running_sample(const Case& sampled, const std::function<bool(double)>& progress, bool limits) {
  try {
    EquilibriumResult result = run_equilibrium(sampled, {}, progress);
    if (limits) add_film_limits(sampled, result, progress);
    return result;
  } catch (const Error&) {
    return not_run(*sampled.equilibrium);
  }
}

}  // namespace bumpfoil
