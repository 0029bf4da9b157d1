#include "bumpfoil/ensemble/parallel_runs.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <vector>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

using namespace std::chrono_literals;
/// Time between ticks: the delay of an interruption.
constexpr auto tick_interval = 20ms;

/// Shared by the running threads and the waiting one.
class Runs {
 public:
  Runs(RunQueue& queue, const NumberedRun& run, unsigned workers) : queue_(queue), run_(run), working_(workers) {}

  /// Executes runs until there are no more. Called by several threads.
  void work() {
    try {
      while (const std::optional<std::size_t> number = queue_.next()) {
        run_(*number, [this](double) { return !stopped_; });
      }
    } catch (...) {
      fail();
    }
    const std::lock_guard lock(mutex_);
    --working_;
    changed_.notify_one();
  }

  /// Ticks immediately and then at intervals, until no thread is working.
  void wait(const std::function<bool()>& tick) {
    std::unique_lock lock(mutex_);
    do {
      lock.unlock();
      try {
        if (!tick()) stop();
      } catch (...) {
        fail();
      }
      lock.lock();
    } while (!changed_.wait_for(lock, tick_interval, [this] { return working_ == 0; }));
  }

  /// @return false if the runs were stopped   @throws the first exception of a run
  [[nodiscard]] bool finished() const {
    if (error_) std::rethrow_exception(error_);
    return !stopped_;
  }

 private:
  /// Stores the current exception.
  void fail() {
    stop();
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
  }

  void stop() {
    stopped_ = true;
    queue_.close();
  }

  RunQueue& queue_;
  const NumberedRun& run_;
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  unsigned working_;
  std::exception_ptr error_;
};

/// Runs 0, 1, 2, ...
class CountedRuns : public RunQueue {
 public:
  explicit CountedRuns(std::size_t runs) : fractions_(runs) {}

  std::optional<std::size_t> next() override {
    const std::size_t number = closed_ ? fractions_.size() : next_++;
    return number < fractions_.size() ? std::optional(number) : std::nullopt;
  }

  void close() override { closed_ = true; }

  void set_fraction(std::size_t number, double fraction) { fractions_[number] = fraction; }

  /// Completed fraction of all runs.
  [[nodiscard]] double done() const {
    double sum = 0.0;
    for (const std::atomic<double>& fraction : fractions_) sum += fraction;
    return sum / static_cast<double>(fractions_.size());
  }

 private:
  std::vector<std::atomic<double>> fractions_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> closed_{false};
};

}  // namespace

unsigned available_threads() {
  return static_cast<unsigned>(std::max(1, tbb::info::default_concurrency()));
}

bool run_in_parallel(RunQueue& queue, unsigned threads, const NumberedRun& run, const std::function<bool()>& tick) {
  BUMPFOIL_ASSERT(threads > 0);
  Runs runs(queue, run, threads);
  // The calling thread counts towards the limit, but executes no runs.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads + 1);
  tbb::task_arena arena(static_cast<int>(threads), 0);
  tbb::task_group group;
  for (unsigned i = 0; i < threads; ++i) arena.enqueue(group.defer([&runs] { runs.work(); }));
  runs.wait(tick);
  group.wait();
  return runs.finished();
}

bool run_in_parallel(std::size_t runs, unsigned threads, const NumberedRun& run, const ProgressCallback& progress) {
  CountedRuns counted(runs);
  const auto workers = static_cast<unsigned>(std::min<std::size_t>(threads, std::max<std::size_t>(runs, 1)));
  return run_in_parallel(
      counted, workers,
      [&](std::size_t number, const ProgressCallback& goes_on) {
        run(number, [&](double fraction) {
          counted.set_fraction(number, fraction);
          return goes_on(fraction);
        });
        counted.set_fraction(number, 1.0);
      },
      [&] { return !progress || progress(counted.done()); });
}

}  // namespace bumpfoil
