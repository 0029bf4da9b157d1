#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "results/result_grid.hpp"

namespace bumpfoil {

/// What sweeps keep of cycles, over direction or cycle and, of the loops, increment. Of a cycle that was not begun it
/// is known that it did not converge and, of an interrupted run, its status.
ResultGrid cycle_grid(const Case& input, const CycleResult& result, RunStatus status, bool with_loops);

/// One row for each cycle, begun or not.
std::string cycle_rows(const Case& input, const CycleResult& result, RunStatus status);

}  // namespace bumpfoil
