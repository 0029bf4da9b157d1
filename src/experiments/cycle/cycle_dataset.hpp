#pragma once

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/results/table.hpp"

namespace bumpfoil {

/// Extent of a dataset.
enum class Extent {
  quantities,  ///< of cycles only
  loops,       ///< also displacement and force of every increment
  recorded,    ///< of a path: results available during the run
  totals,      ///< the remaining results at its end
  everything,  ///< of every increment, bump and foot, and the geometry needed to draw them
};

/// Cycles over direction or number and, for loops, increment; a path has neither. A cycle that was not started is
/// recorded as not converged and, in an interrupted run, with its status.
Dataset cycle_dataset(const Case& input, const CycleResult& result, RunStatus status, Extent extent);

/// One row per cycle, started or not.
Table cycle_rows(const Case& input, const CycleResult& result, RunStatus status);

}  // namespace bumpfoil
