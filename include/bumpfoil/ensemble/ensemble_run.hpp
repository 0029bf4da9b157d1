#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "bumpfoil/ensemble/run_flow.hpp"
#include "bumpfoil/experiments/sampling.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/row_log.hpp"

namespace bumpfoil {

/// Whether an ensemble is large enough is asked after this many samples, and twice as many, and so on, of those that
/// have no gap before them: so the answer does not depend on threads.
inline constexpr std::size_t ensemble_round = 1000;

/// How an ensemble is run, and its callbacks. All except the threads may be omitted.
struct EnsembleRun {
  unsigned threads{1};
  /// Called repeatedly with the number of completed samples; returning false stops the run.
  std::function<bool(double done)> progress{};
  /// Asked after every whole round.
  std::function<bool()> enough{};
  /// Called now and then to give samples of the flow to others, and to put back what came of them.
  std::function<void(RunFlow&)> share{};
};

/// Runs the samples of an ensemble, for several threads at once.
class EnsembleSampler {
 public:
  /// @param input, layout  outlive it
  EnsembleSampler(const Case& input, const EnsembleLayout& layout);

  /// @return the row of a sample, which its number alone decides on; nothing if `progress` stopped it
  [[nodiscard]] std::optional<std::vector<double>> run(std::size_t number, const ProgressCallback& progress);

 private:
  [[nodiscard]] SampleRun take_run();
  void give_back(SampleRun run);

  const Case& input_;
  const EnsembleLayout& layout_;
  std::mutex mutex_;
  std::vector<SampleRun> idle_;  ///< those that no thread has just now
};

/// Runs the samples of an ensemble that its log has not yet, and adds them to it: in the order of their numbers, at
/// least once a second. What the log holds in the end does not depend on who ran them, nor on where it was interrupted
/// before, to the last bit.
/// @return false if it was stopped; samples that were under way then, and those behind them, are left out
/// @throws Error (file) if the log cannot be written
bool run_ensemble(const Case& input, const EnsembleLayout& layout, RowLog& log, const EnsembleRun& run);

}  // namespace bumpfoil
