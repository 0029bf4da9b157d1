#pragma once

#include <chrono>
#include <string_view>

namespace bumpfoil {

/// Shows the progress of a run: a changing line on standard error, only on a terminal and only after a second. A job of
/// several ranks has no terminal; its log gets a line after 1, 2, 4 s and so on, finally once a minute.
class ProgressBar {
 public:
  /// @param wanted   false: no output
  /// @param begun fraction completed before
  /// @param for_log  lines for a log
  explicit ProgressBar(bool wanted, double begun = 0.0, bool for_log = false);
  ~ProgressBar();  ///< removes the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param fraction done, 0..1 @param rate rate, as text
  void show(double fraction, std::string_view rate = {});

 private:
  using Clock = std::chrono::steady_clock;
  bool bar_, log_;
  double begun_;
  Clock::time_point start_{Clock::now()};
  bool shown_{};
  Clock::time_point next_shown_;
};

}  // namespace bumpfoil
