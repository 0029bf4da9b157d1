#pragma once

#include <chrono>
#include <string_view>

namespace bumpfoil {

/// A line on standard error that shows how far a run is: on a terminal only, and after a second only.
class ProgressBar {
 public:
  /// @param wanted false keeps it silent
  explicit ProgressBar(bool wanted);
  ~ProgressBar();  ///< removes the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param fraction done, 0..1   @param rate  how fast it goes, in words
  void show(double fraction, std::string_view rate = {});

 private:
  using Clock = std::chrono::steady_clock;
  bool active_;
  Clock::time_point start_{Clock::now()};
  Clock::time_point last_shown_{};
};

}  // namespace bumpfoil
