#pragma once

#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "bumpfoil/ensemble/parallel_runs.hpp"

namespace bumpfoil {

/// Runs with consecutive numbers.
struct RunRange {
  std::size_t first{}, count{};
};

/// Distributes runs to threads: numbers are handed out in order, rows of results come back in any order and leave in
/// the order of their numbers. For several threads at once.
///
/// Threads run independently: one waits only where a run takes so long that others would be a window ahead of it. That
/// bounds the memory.
class RunFlow : public RunQueue {
 public:
  /// @param begin, end  numbers of the runs: end is none of them
  /// @param window      runs, from the first that is missing, that may be out or back
  RunFlow(std::size_t begin, std::size_t end, std::size_t window);

  /// Waits for room in the window, and in the end until all rows are back or the flow is closed.
  std::optional<std::size_t> next() override;

  void close() override;
  [[nodiscard]] bool closed() const;

  /// As many as there is room for, at most `count`; for those who must not wait.
  RunRange take(std::size_t count);

  /// The row of a run that went out comes back.
  void put(std::size_t number, std::vector<double> row);

  /// Rows that are back, one behind the other, from the first run that has not left yet to before the first that is
  /// missing; at most `count`.
  std::vector<double> leave(std::size_t count);

  /// Runs that came back or were there before, and those that wait to leave.
  [[nodiscard]] std::size_t done() const;
  [[nodiscard]] std::size_t waiting() const;

 private:
  [[nodiscard]] std::size_t room() const;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t end_, window_;
  std::size_t next_;   ///< to go out
  std::size_t first_;  ///< that has not left
  std::map<std::size_t, std::vector<double>> rows_;
  bool closed_{};
};

}  // namespace bumpfoil
