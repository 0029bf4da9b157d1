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
constexpr int width = 40;

}  // namespace

ProgressBar::ProgressBar(bool wanted) : active_(wanted && ::isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (last_shown_ != Clock::time_point{}) std::fputs("\r\x1b[K", stderr);
}

void ProgressBar::show(double fraction, std::string_view rate) {
  if (!active_) return;
  const Clock::time_point now = Clock::now();
  if (now - start_ < patience || now - last_shown_ < refresh) return;
  last_shown_ = now;
  const double done = std::clamp(fraction, 0.0, 1.0);
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const auto filled = static_cast<std::size_t>(done * width);
  const std::string remaining = done > 0.0 ? fmt::format("{:.0f} s left", elapsed * (1.0 - done) / done) : "";
  const std::string line = fmt::format("\r[{:<{}}] {:3.0f} %  {}{}{}\x1b[K", std::string(filled, '#'), width,
                                       100.0 * done, rate, rate.empty() ? "" : ", ", remaining);
  std::fputs(line.c_str(), stderr);
}

}  // namespace bumpfoil
