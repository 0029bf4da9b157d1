#include "bumpfoil/ensemble/running_sample.hpp"

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/equilibrium/film_limits.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/case_names.hpp"

namespace bumpfoil {
namespace {

/// The case to run; nothing if it is invalid.
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

std::vector<const Variable*> sampled_variables(const Dataset& run) {
  std::vector<const Variable*> sampled;
  for (const Variable& variable : run.variables) {
    if (variable.dims.empty() && (variable.meaning.tags & tag::sampled) != 0) sampled.push_back(&variable);
  }
  BUMPFOIL_ASSERT(!sampled.empty() && sampled.front()->meaning.name == "status");
  return sampled;
}

std::optional<std::vector<double>> run_rotor_sample(const Case& sampled, EnsembleCommand command,
                                                    const std::function<bool(double)>& progress) {
  return unless_faulty([&] {
    const Outcome outcome = experiment_named(name_of(command)).run(sampled, progress);
    const Dataset run = outcome.dataset();
    return each(sampled_variables(run), [](const Variable* variable) { return variable->values().front(); });
  });
}

}  // namespace bumpfoil
