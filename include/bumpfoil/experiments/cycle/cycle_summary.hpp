#pragma once

#include <string>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// How a run of cycles ended.
RunStatus status_of(const CycleResult& result);

/// Contents of summary.json: the command, the case as understood, version, solver, run id and checksums, and the
/// derived quantities of every cycle. Quantities that are not known, and none but these, are null.
std::string summary_json(const Case& input, const CycleResult& result, RunStatus status, const Manifest& manifest);

}  // namespace bumpfoil
