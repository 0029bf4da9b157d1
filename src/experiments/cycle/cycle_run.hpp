#pragma once

#include <functional>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Runs a cycle of a bearing along a direction (rad), from the unstressed foils.
using CycleRun = std::function<Cycle(double direction, const ProgressCallback& progress)>;

/// Runs cycles of a case with its model. The case must outlive it.
/// @throws Error (input) if the case cannot be built.
CycleRun make_cycle_run(const Case& input);

/// The same for all models except Le Lez (2007).
CycleRun present_cycle_run(const Case& input);

}  // namespace bumpfoil
