#pragma once

#include <cstddef>
#include <utility>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Runs cycles one after the other and reports their progress. Cycles of a strip depend on the previous one and end at
/// the first failure. An interruption always ends the run.
/// @param run  number of the cycle from 0, and a callback for its own progress -> Cycle
template <typename Run>
CycleResult run_each_cycle(Experiment experiment, const Case& input, std::ptrdiff_t cycles,
                           const ProgressCallback& progress, const Run& run) {
  CycleResult result{.solver = input.solver.chosen(),
                     .experiment = experiment,
                     .due = static_cast<std::size_t>(cycles),
                     .over_width = experiment == Experiment::cycle && input.varies_over_the_width(),
                     .cycles = {}};
  bool stopped = false;
  for (std::size_t i = 0; std::cmp_less(i, cycles) && !stopped; ++i) {
    result.cycles.push_back(run(i, [&](double fraction) {
      stopped = progress && !progress((static_cast<double>(i) + fraction) / static_cast<double>(cycles));
      return !stopped;
    }));
    if (experiment == Experiment::strip && !result.cycles.back().converged()) break;
  }
  return result;
}

}  // namespace bumpfoil
