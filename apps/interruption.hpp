#pragma once

namespace bumpfoil {

/// While it lives, Ctrl-C and the signals by which systems end programs (SIGTERM, SIGHUP, and SIGXCPU of a limit of
/// time) are noted instead of ending the program; a second Ctrl-C ends it. What was ignored stays ignored, such as
/// SIGHUP under nohup.
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

  [[nodiscard]] bool interrupted() const;
};

}  // namespace bumpfoil
