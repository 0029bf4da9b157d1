#pragma once

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/results/table.hpp"

namespace bumpfoil {

/// Rows of cycle.csv, strip.csv or path.csv: one for each cycle and increment.
Table increment_rows(const CycleResult& result);

}  // namespace bumpfoil
