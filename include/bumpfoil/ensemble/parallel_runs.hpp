#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Threads that the machine runs at once, as far as this process may use them; at least one.
unsigned available_threads();

/// One of many runs: its number, and a callback for its own progress that tells it to stop.
using NumberedRun = std::function<void(std::size_t, const ProgressCallback&)>;

/// Hands out the numbers of runs, to several threads at once.
class RunQueue {
 public:
  virtual ~RunQueue() = default;

  /// The run to be begun next, for which it may wait; nothing when there are no more.
  virtual std::optional<std::size_t> next() = 0;

  /// From now on there are no more: those that wait go on.
  virtual void close() = 0;
};

/// Executes independent runs, several at a time, as threads become free. Each run writes its result to its own place,
/// so that results do not depend on the number of threads.
///
/// @param threads  that run; the calling one only waits
/// @param tick     called now and then by the calling thread alone; returning false closes the queue and stops the runs
///                 that are under way
/// @return false if it was stopped
/// @throws what the first run that throws does, when those under way have been stopped
bool run_in_parallel(RunQueue& queue, unsigned threads, const NumberedRun& run, const std::function<bool()>& tick);

/// The same for a known number of runs, begun in the order of their numbers from 0.
///
/// @param progress  called as `tick` is, with the part of all runs that is done; may be empty
bool run_in_parallel(std::size_t runs, unsigned threads, const NumberedRun& run, const ProgressCallback& progress = {});

}  // namespace bumpfoil
