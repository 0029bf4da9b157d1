#pragma once

#include <cstddef>
#include <functional>

#include "bumpfoil/analysis/cycle.hpp"

namespace bumpfoil {

/// Threads that the machine runs at once, as far as this process may use them; at least one.
unsigned available_threads();

/// One of many runs: its number from 0, and a callback for its own progress that tells it to stop.
using NumberedRun = std::function<void(std::size_t, const ProgressCallback&)>;

/// Does runs that have nothing to do with each other, several at a time, each once and in the order of their numbers as
/// threads become free. What a run gives back it writes to a place of its own, so that nothing depends on the number of
/// threads.
///
/// @param threads   that run; the calling one only waits
/// @param progress  called now and then by the calling thread alone, with the part of all runs that is done; returning
///                  false stops those that are under way, and none is begun any more
/// @return false if it was stopped
/// @throws what the first run that throws does, when those under way have been stopped
bool run_in_parallel(std::size_t runs, unsigned threads, const NumberedRun& run, const ProgressCallback& progress = {});

}  // namespace bumpfoil
