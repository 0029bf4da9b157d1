#include "bumpfoil/studies/ensemble_run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <vector>

#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/studies/parallel_runs.hpp"

namespace bumpfoil {
namespace {

using Clock = std::chrono::steady_clock;
/// Between two writes to the log: as much work as is lost when the power fails.
constexpr auto write_interval = std::chrono::milliseconds(200);

/// Samples that are run together, and what of them is in the log.
class Round {
 public:
  Round(const Case& input, const EnsembleLayout& layout, std::size_t size, EnsembleLog& log)
      : input_(input), layout_(layout), log_(log), first_(log.samples()), rows_(size), done_(size) {}

  /// For several threads at once.
  void run(std::size_t i, const ProgressCallback& progress) {
    const Case sampled = sampled_case(input_, draw_sample(input_, first_ + i));
    bool stopped = false;
    const CycleResult result = run_sample(sampled, [&](double fraction) {
      stopped = stopped || !progress(fraction);
      return !stopped;
    });
    if (stopped) return;
    rows_[i] = make_ensemble_row(layout_, sampled, result);
    done_[i].store(true, std::memory_order_release);
  }

  /// Writes what is done, up to the first that is not. For one thread.
  void write() {
    std::vector<double> rows;
    for (; written_ < rows_.size() && done_[written_].load(std::memory_order_acquire); ++written_) {
      std::vector<double>& row = rows_[written_];
      rows.insert(rows.end(), row.begin(), row.end());
      row = {};
    }
    if (!rows.empty()) log_.append(rows);
    last_write_ = Clock::now();
  }

  [[nodiscard]] bool is_time() const { return Clock::now() - last_write_ >= write_interval; }

 private:
  const Case& input_;
  const EnsembleLayout& layout_;
  EnsembleLog& log_;
  std::size_t first_;  ///< sample
  std::vector<std::vector<double>> rows_;
  std::vector<std::atomic<bool>> done_;
  std::size_t written_{};
  Clock::time_point last_write_{Clock::now()};
};

}  // namespace

bool run_ensemble(const Case& input, const EnsembleLayout& layout, unsigned threads, EnsembleLog& log,
                  const EnsembleProgress& progress, const std::function<bool()>& enough) {
  const auto samples = static_cast<std::size_t>(input.montecarlo->samples);
  while (log.samples() < samples) {
    const std::size_t begin = log.samples();
    const bool whole_rounds = begin > 0 && begin % ensemble_round == 0;
    if (whole_rounds && enough && enough()) return true;
    const std::size_t end = std::min(samples, (begin / ensemble_round + 1) * ensemble_round);
    Round round(input, layout, end - begin, log);
    const bool finished = run_in_parallel(
        end - begin, threads,
        [&round](std::size_t i, const ProgressCallback& progress_of_run) { round.run(i, progress_of_run); },
        [&](double fraction) {
          if (round.is_time()) round.write();
          const auto size = static_cast<double>(end - begin);
          return !progress || progress(static_cast<double>(begin) + fraction * size);
        });
    round.write();
    if (!finished) return false;
  }
  return true;
}

}  // namespace bumpfoil
