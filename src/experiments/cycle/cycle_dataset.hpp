#pragma once

#include <string>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// How much a dataset holds of what was run.
enum class Extent {
  quantities,  ///< of cycles alone
  loops,       ///< displacement and force of every increment, too
  recorded,    ///< of a path: what is known while it goes on
  totals,      ///< what it has beyond this in the end
  everything,  ///< of every increment, bump and foot, and the geometry that it takes to draw them
};

/// Cycles over direction or number and, of the loops, increment; a path has neither. Of a cycle that was not begun it
/// is known that it did not converge and, of an interrupted run, its status.
Dataset cycle_dataset(const Case& input, const CycleResult& result, RunStatus status, Extent extent);

/// One row for each cycle, begun or not.
std::string cycle_rows(const Case& input, const CycleResult& result, RunStatus status);

}  // namespace bumpfoil
