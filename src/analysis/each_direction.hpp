#pragma once

#include <chrono>

#include "bumpfoil/analysis/cycle.hpp"

namespace bumpfoil {

/// Runs one cycle per direction of the case, reports progress and measures time.
/// @param make_runner  direction (rad) -> a runner with `bool take_increment()`, false where the cycle ends early, and
///                     `Cycle finish()`
template <typename MakeRunner>
CycleResult run_each_direction(const Case& input, const ProgressCallback& progress, const MakeRunner& make_runner) {
  CycleResult result{.solver = input.solver.name, .cycles = {}};
  const int increments = 2 * input.cycle.steps + 1;
  bool stopped = false;
  for (const double direction : input.cycle.directions) {
    const auto start = std::chrono::steady_clock::now();
    auto runner = make_runner(direction);
    for (int k = 0; k < increments && !stopped; ++k) {
      if (!runner.take_increment()) break;
      const double done = static_cast<double>(result.cycles.size()) + static_cast<double>(k + 1) / increments;
      stopped = progress && !progress(done / static_cast<double>(input.cycle.directions.size()));
    }
    result.cycles.push_back(runner.finish());
    result.cycles.back().wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (stopped) break;
  }
  return result;
}

}  // namespace bumpfoil
