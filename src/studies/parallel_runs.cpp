#include "bumpfoil/studies/parallel_runs.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

using namespace std::chrono_literals;
/// Between two reports of progress: as long as an interruption goes unnoticed.
constexpr auto report_interval = 20ms;

/// Hands out the runs, and keeps what is done of them.
class Runs {
 public:
  Runs(std::size_t runs, const NumberedRun& run) : run_(run), fractions_(runs) {}

  /// Does one run after the other until there are no more. For several threads at once.
  void work() {
    try {
      for (std::size_t i = next_++; i < fractions_.size() && !stopped_; i = next_++) {
        run_(i, [this, i](double fraction) {
          fractions_[i] = fraction;
          return !stopped_;
        });
        if (!stopped_) fractions_[i] = 1.0;
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      stopped_ = true;
    }
    const std::lock_guard lock(mutex_);
    --working_;
    changed_.notify_one();
  }

  /// Reports progress until nobody works any more. @return false if it stopped them
  bool wait(const ProgressCallback& progress) {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, report_interval, [this] { return working_ == 0; })) {
      lock.unlock();
      if (progress && !progress(done())) stopped_ = true;
      lock.lock();
    }
    if (error_) std::rethrow_exception(error_);
    return !stopped_;
  }

  /// Says that one more works, or that it does not after all.
  void expect(int workers) {
    const std::lock_guard lock(mutex_);
    working_ += workers;
  }

 private:
  [[nodiscard]] double done() const {
    double sum = 0.0;
    for (const std::atomic<double>& fraction : fractions_) sum += fraction;
    return sum / static_cast<double>(fractions_.size());
  }

  const NumberedRun& run_;
  std::vector<std::atomic<double>> fractions_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  int working_{};
  std::exception_ptr error_;
};

}  // namespace

unsigned available_threads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

bool run_in_parallel(std::size_t runs, unsigned threads, const NumberedRun& run, const ProgressCallback& progress) {
  BUMPFOIL_ASSERT(threads > 0);
  Runs all(runs, run);
  std::vector<std::jthread> pool;
  while (pool.size() < std::min<std::size_t>(threads, runs)) {
    all.expect(1);
    try {
      pool.emplace_back([&all] { all.work(); });
    } catch (const std::system_error&) {
      all.expect(-1);
      if (pool.empty()) throw;
      break;  // the system gives no more: those that are there do all of it
    }
  }
  return all.wait(progress);
}

}  // namespace bumpfoil
