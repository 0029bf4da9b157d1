#include "progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace bumpfoil {
namespace {

using namespace std::chrono_literals;
constexpr auto patience = 1s;
constexpr auto refresh = 100ms;
constexpr auto longest_silence = 60s;
constexpr int width = 40;

std::string time_text(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.0f} h", seconds / 3600.0);
}

}  // namespace

ProgressBar::ProgressBar(bool wanted, double begun, bool for_log)
    : bar_(wanted && !for_log && ::isatty(STDERR_FILENO) != 0),
      log_(wanted && for_log),
      begun_(begun),
      next_shown_(start_ + patience) {}

ProgressBar::~ProgressBar() {
  if (bar_ && shown_) std::fputs("\r\x1b[K", stderr);
}

void ProgressBar::show(double fraction, std::string_view rate) {
  const Clock::time_point now = Clock::now();
  if ((!bar_ && !log_) || now < next_shown_) return;
  shown_ = true;
  const double done = std::clamp(fraction, 0.0, 1.0);
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  std::string text = fmt::format("{:3.0f} %", 100.0 * done);
  if (!rate.empty()) text += fmt::format("  {}", rate);
  if (done > begun_) {
    text += fmt::format("{}{} left", rate.empty() ? "  " : ", ", time_text(elapsed * (1.0 - done) / (done - begun_)));
  }
  if (log_) {
    std::fputs(fmt::format("{}\n", text).c_str(), stderr);
    next_shown_ = now + std::min<Clock::duration>(now - start_, longest_silence);
    return;
  }
  next_shown_ = now + refresh;
  const auto filled = static_cast<std::size_t>(done * width);
  std::fputs(fmt::format("\r[{:<{}}] {}\x1b[K", std::string(filled, '#'), width, text).c_str(), stderr);
}

}  // namespace bumpfoil
