#pragma once

#include <string_view>

#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil {

/// Advice to reduce memory.
inline constexpr std::string_view cycle_advice = "use fewer steps or directions";

/// Outcome of a run whose results are cycles.
Outcome cycle_outcome(const Case& input, CycleResult result);

/// Runs a path and stages its files during the run.
Outcome stream_path(const Case& input, const Provenance& provenance, ResultFolder& folder,
                    const std::function<CycleResult(const RecordSink&)>& run);

/// Sweep interface of experiments whose results are cycles.
Sweeping cycle_sweeping(Experiment experiment, ExperimentRun run);

}  // namespace bumpfoil
