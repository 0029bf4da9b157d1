#pragma once

#include <chrono>
#include <cstddef>
#include <utility>

#include "bumpfoil/analysis/cycle.hpp"

namespace bumpfoil {

/// Runs loops, reports progress and measures time. Loops of a strip follow from each other: the first that fails is the
/// last.
/// @param make_runner  number of the loop from 0 -> a runner with `int due()`, the increments of a loop,
///                     `bool take_increment()`, false where the loop ends early, and `Cycle finish()`
template <typename MakeRunner>
CycleResult run_loops(Experiment experiment, const Case& input, std::ptrdiff_t loops, const ProgressCallback& progress,
                      const MakeRunner& make_runner) {
  CycleResult result{.solver = input.solver.name, .experiment = experiment, .cycles = {}};
  bool stopped = false;
  for (std::size_t i = 0; std::cmp_less(i, loops) && !stopped; ++i) {
    const auto start = std::chrono::steady_clock::now();
    auto runner = make_runner(i);
    for (int k = 0; k < runner.due() && !stopped; ++k) {
      if (!runner.take_increment()) break;
      const double done = static_cast<double>(i) + static_cast<double>(k + 1) / runner.due();
      stopped = progress && !progress(done / static_cast<double>(loops));
    }
    result.cycles.push_back(runner.finish());
    result.cycles.back().wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (experiment == Experiment::strip && !result.cycles.back().converged) break;
  }
  return result;
}

}  // namespace bumpfoil
