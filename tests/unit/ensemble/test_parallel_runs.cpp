#include "bumpfoil/ensemble/parallel_runs.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace bumpfoil {
namespace {

using namespace std::chrono_literals;

TEST(ParallelRuns, EachRunIsDoneOnceWhateverTheThreads) {
  EXPECT_GE(available_threads(), 1U);
  for (const unsigned threads : {1U, 2U, 7U, 200U}) {
    std::vector<int> done(100);
    EXPECT_TRUE(run_in_parallel(done.size(), threads, [&](std::size_t i, const ProgressCallback&) { ++done[i]; }));
    EXPECT_EQ(done, std::vector<int>(100, 1)) << threads;
  }
  EXPECT_TRUE(run_in_parallel(0, 3, [](std::size_t, const ProgressCallback&) { FAIL(); }));
}

TEST(ParallelRuns, RunsAtTheSameTime) {
  // Each run waits for the other: in sequence they would wait forever.
  std::atomic<int> here{0};
  EXPECT_TRUE(run_in_parallel(2, 2, [&](std::size_t, const ProgressCallback&) {
    ++here;
    while (here < 2) std::this_thread::yield();
  }));
}

TEST(ParallelRuns, CallerAloneHearsOfTheProgressOfAll) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<bool> heard{false};
  double last = 0.0;
  run_in_parallel(
      4, 2,
      [&](std::size_t, const ProgressCallback& progress) {
        EXPECT_TRUE(progress(0.5));
        while (!heard) std::this_thread::sleep_for(1ms);
      },
      [&](double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1.0);
        last = fraction;
        if (fraction > 0.0) heard = true;
        return true;
      });
  EXPECT_GT(last, 0.0);
}

TEST(ParallelRuns, TellsOfTheProgressOfRunsThatEndAtOnce) {
  int told = 0;
  EXPECT_TRUE(run_in_parallel(
      1, 1, [](std::size_t, const ProgressCallback&) {}, [&](double) { return ++told > 0; }));
  EXPECT_GE(told, 1);
}

TEST(ParallelRuns, StopsWhatIsUnderWayAndBeginsNoMore) {
  std::atomic<int> begun{0};
  EXPECT_FALSE(run_in_parallel(
      100, 2,
      [&](std::size_t, const ProgressCallback& progress) {
        ++begun;
        while (progress(0.1)) std::this_thread::sleep_for(1ms);
      },
      [](double) { return false; }));
  EXPECT_LE(begun, 2);
}

TEST(ParallelRuns, WhatARunThrowsReachesTheCaller) {
  std::atomic<int> begun{0};
  EXPECT_THROW(run_in_parallel(100, 2,
                               [&](std::size_t i, const ProgressCallback& progress) {
                                 ++begun;
                                 if (i == 1) throw std::runtime_error("no");
                                 while (progress(0.1)) std::this_thread::sleep_for(1ms);
                               }),
               std::runtime_error);
  EXPECT_LE(begun, 3);
}

/// Provides one run, then blocks until it is closed.
class OneRun : public RunQueue {
 public:
  std::optional<std::size_t> next() override {
    std::unique_lock lock(mutex_);
    if (!given_) {
      given_ = true;
      return 5;
    }
    changed_.wait(lock, [this] { return closed_; });
    return std::nullopt;
  }
  void close() override {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool given_{}, closed_{};
};

TEST(ParallelRuns, StoppingReachesThoseWhoWaitForARun) {
  OneRun queue;
  std::atomic<std::size_t> number{0};
  EXPECT_FALSE(run_in_parallel(
      queue, 3, [&](std::size_t i, const ProgressCallback&) { number = i; }, [&] { return number == 0; }));
  EXPECT_EQ(number, 5U);
}

TEST(ParallelRuns, WhatARunThrowsReachesThoseWhoWaitForARun) {
  OneRun queue;
  EXPECT_THROW(
      run_in_parallel(
          queue, 3, [](std::size_t, const ProgressCallback&) { throw std::runtime_error("no"); }, [] { return true; }),
      std::runtime_error);
}

TEST(ParallelRuns, WhatTheTickThrowsStopsTheRuns) {
  std::atomic<int> begun{0};
  EXPECT_THROW(run_in_parallel(
                   100, 2,
                   [&](std::size_t, const ProgressCallback& progress) {
                     ++begun;
                     while (progress(0.1)) std::this_thread::sleep_for(1ms);
                   },
                   [](double) -> bool { throw std::runtime_error("no"); }),
               std::runtime_error);
  EXPECT_LE(begun, 2);
}

}  // namespace
}  // namespace bumpfoil
