#pragma once

#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil {

/// What a run has to show whose results are cycles.
Outcome cycle_outcome(const Case& input, CycleResult result);

/// How experiments whose results are cycles are swept.
Sweeping cycle_sweeping(Experiment experiment, ExperimentRun run);

}  // namespace bumpfoil
