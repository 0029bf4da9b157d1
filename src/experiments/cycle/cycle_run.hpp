#pragma once

#include <functional>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Runs a cycle of a bearing along a direction (rad), from the unstressed foils.
using CycleRun = std::function<Cycle(double direction, const ProgressCallback& progress)>;

/// Cycles of a case by the model that it names. The case outlives it.
/// @throws Error (input) if the case cannot be built.
CycleRun make_cycle_run(const Case& input);

/// Those of all models but the Le Lez (2007) one.
CycleRun present_cycle_run(const Case& input);

}  // namespace bumpfoil
