#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil::test_support {

/// The files of a run. @param status  how it ended, instead of how the outcome says
inline std::vector<ResultFile> files_of(std::string_view experiment, const Case& input, Outcome outcome,
                                        std::optional<RunStatus> status = {}, const Provenance& provenance = {}) {
  if (status) outcome.status = *status;
  return result_files(experiment_named(experiment), input, outcome, provenance);
}

/// The files of a run that computes them.
inline std::vector<ResultFile> files_of(std::string_view experiment, const Case& input) {
  return files_of(experiment, input, experiment_named(experiment).run(input, {}));
}

}  // namespace bumpfoil::test_support
