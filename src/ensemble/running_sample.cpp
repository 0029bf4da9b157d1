#include "bumpfoil/ensemble/running_sample.hpp"

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/equilibrium/film_limits.hpp"

namespace bumpfoil {

std::optional<EquilibriumResult> run_running_sample(const Case& sampled, const std::function<bool(double)>& progress,
                                                    bool limits) {
  try {
    EquilibriumResult result = run_equilibrium(sampled, {}, progress);
    if (limits) add_film_limits(sampled, result, progress);
    return result;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace bumpfoil
