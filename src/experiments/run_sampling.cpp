#include "experiments/run_sampling.hpp"

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

std::vector<const Variable*> sampled_variables(const Dataset& run) {
  std::vector<const Variable*> sampled;
  for (const Variable& variable : run.variables) {
    if (variable.dims.empty() && (variable.meaning.tags & tag::sampled) != 0) sampled.push_back(&variable);
  }
  BUMPFOIL_ASSERT(!sampled.empty() && sampled.front()->meaning.name == "status");
  return sampled;
}

}  // namespace

Sampling sampling_of_runs(const WholeRun& whole, const Sweeping& sweeping) {
  const auto layout = [whole, not_begun = sweeping.not_begun](const Case& input) {
    const Outcome none = not_begun(input);
    const Dataset run = none.dataset();
    return EnsembleLayout{
        .place = whole.place,
        .plural = whole.plural,
        .places = {{whole.place.name, 1.0}},
        .columns = each(sampled_variables(run),
                        [](const Variable* variable) { return EnsembleColumn{.meaning = variable->meaning}; }),
        .target = whole.target};
  };
  const auto begin = [run = sweeping.run](const Case& /*input*/) -> SampleRun {
    return [run](const Case& sampled, const ProgressCallback& progress) {
      const Outcome outcome = run(sampled, progress);
      const Dataset found = outcome.dataset();
      return std::vector{SampledPlace{.values = each(sampled_variables(found), [](const Variable* variable) {
                                        return variable->values().front();
                                      })}};
    };
  };
  return {.layout = layout, .begin = begin};
}

Sampling rotor_sampling(std::string_view target, const Sweeping& sweeping) {
  return sampling_of_runs({.place = {"rotor", "1", "the rotor on bearings that are all the sample", whole_number},
                           .plural = "rotors",
                           .target = target},
                          sweeping);
}

}  // namespace bumpfoil
