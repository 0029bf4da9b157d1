#pragma once

#include <cstddef>
#include <functional>

#include "bumpfoil/io/ensemble_layout.hpp"
#include "bumpfoil/io/ensemble_log.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Samples that are run before the next are begun. Whether an ensemble is large enough is asked between two of these,
/// so that the answer does not depend on threads.
inline constexpr std::size_t ensemble_round = 1000;

/// Called now and then, with the samples that are done of all; returning false stops the run.
using EnsembleProgress = std::function<bool(double done)>;

/// Runs the samples of an ensemble that its log has not yet, and adds them to it: in the order of their numbers, at
/// least once a second, whole rounds at last. What the log holds in the end does not depend on the number of threads,
/// nor on where it was interrupted before, to the last bit.
/// @param enough  asked after every whole round; may be empty
/// @return false if it was stopped; samples that were under way then, and those behind them, are left out
/// @throws Error (file) if the log cannot be written
bool run_ensemble(const Case& input, const EnsembleLayout& layout, unsigned threads, EnsembleLog& log,
                  const EnsembleProgress& progress = {}, const std::function<bool()>& enough = {});

}  // namespace bumpfoil
