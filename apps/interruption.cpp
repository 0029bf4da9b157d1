#include "interruption.hpp"

#include <csignal>

namespace bumpfoil {
namespace {

volatile std::sig_atomic_t signal_seen = 0;

extern "C" void note_signal(int signal) {
  signal_seen = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptionGuard::InterruptionGuard() {
  signal_seen = 0;
  std::signal(SIGINT, note_signal);
}

InterruptionGuard::~InterruptionGuard() {
  std::signal(SIGINT, SIG_DFL);
}

bool InterruptionGuard::interrupted() const {
  return signal_seen != 0;
}

}  // namespace bumpfoil
