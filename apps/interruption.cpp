#include "interruption.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <string_view>

#include "commands.hpp"

namespace bumpfoil {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU};
std::array<struct sigaction, signals.size()> actions_before{};
/// Signals may arrive on any thread.
std::atomic<bool> signal_seen{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void note_signal(int signal) {
  // Other signals may arrive twice without a second request: to a group and to its member, or every second.
  if (signal == SIGINT && signal_seen) {
    constexpr std::string_view message = "\nbumpfoil: interrupted twice: results not yet written are lost\n";
    [[maybe_unused]] const ssize_t count = ::write(STDERR_FILENO, message.data(), message.size());
    ::_exit(static_cast<int>(ExitCode::interrupted));
  }
  signal_seen = true;
}

}  // namespace

InterruptionGuard::InterruptionGuard() {
  signal_seen = false;
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ::sigaction(signals[i], nullptr, &actions_before[i]);
    if (actions_before[i].sa_handler != SIG_IGN) ::sigaction(signals[i], &action, nullptr);
  }
}

InterruptionGuard::~InterruptionGuard() {
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &actions_before[i], nullptr);
}

bool InterruptionGuard::interrupted() const {
  return signal_seen;
}

}  // namespace bumpfoil
