#include "bumpfoil/experiments/experiments.hpp"

#include <algorithm>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "experiments/registry.hpp"
#include "experiments/run_record.hpp"
#include "results/result_files.hpp"

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

std::vector<ResultFile> result_files(const ExperimentInfo& experiment, const Case& input, const Outcome& outcome,
                                     const Provenance& provenance) {
  const auto netcdf = std::find_if(experiment.files.begin(), experiment.files.end(),
                                   [](const std::string& name) { return name.ends_with(".nc"); });
  BUMPFOIL_ASSERT(netcdf != experiment.files.end() && outcome.contents);
  return make_result_files(record_of(experiment.name, input, outcome, provenance), *netcdf, experiment.advice,
                           [&outcome](const std::string& run_id) {
                             ResultContents contents = outcome.contents(run_id);
                             contents.dataset = outcome.dataset();
                             return contents;
                           });
}

const std::vector<std::string>& result_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    const auto add = [&names](const std::string& name) {
      if (name != "case.toml" && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const ExperimentInfo& experiment : experiments()) {
      for (const std::string& name : experiment.files) add(name);
    }
    // Of sweeps, ensembles, studies and pages, which are no experiments.
    for (const char* name : {"sweep.csv", "sweep.nc", "ensemble.nc", "study.json", "picture.svg", "report.html"})
      add(name);
    return names;
  }();
  return all;
}

std::vector<InputError> errors_of_run(const std::string& command, const Case& input) {
  const auto found = std::find_if(experiments().begin(), experiments().end(),
                                  [&](const ExperimentInfo& experiment) { return experiment.name == command; });
  return found == experiments().end() || !found->check ? std::vector<InputError>{} : found->check(input);
}

}  // namespace bumpfoil
