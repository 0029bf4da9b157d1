#include "bumpfoil/ensemble/running_sample.hpp"

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/equilibrium/film_limits.hpp"

namespace bumpfoil {
namespace {

/// What is run of a case; nothing if it makes no bearing.
template <typename Run>
auto unless_faulty(const Run& run) -> std::optional<decltype(run())> {
  try {
    return run();
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<EquilibriumResult> run_running_sample(const Case& sampled, const std::function<bool(double)>& progress,
                                                    bool limits) {
  return unless_faulty([&] {
    EquilibriumResult result = run_equilibrium(sampled, {}, progress);
    if (limits) add_film_limits(sampled, result, progress);
    return result;
  });
}

std::optional<StabilityResult> run_rotor_sample(const Case& sampled, const std::function<bool(double)>& progress) {
  return unless_faulty([&] { return run_stability(sampled, progress); });
}

std::optional<UnbalanceResult> run_unbalance_sample(const Case& sampled, const std::function<bool(double)>& progress) {
  return unless_faulty([&] { return run_unbalance(sampled, progress); });
}

}  // namespace bumpfoil
