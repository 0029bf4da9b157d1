#pragma once

#include <string_view>

#include "bumpfoil/experiments/experiments.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {

/// A run of an experiment with this outcome. @param input, provenance  outlive the record
inline RunRecord record_of(std::string_view command, const Case& input, const Outcome& outcome,
                           const Provenance& provenance) {
  return {.input = input,
          .command = command,
          .status = outcome.status,
          .failures = outcome.failures,
          .warnings = outcome.warnings,
          .provenance = provenance};
}

}  // namespace bumpfoil
