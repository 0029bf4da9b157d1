#pragma once

namespace bumpfoil {

/// During its lifetime, Ctrl-C and termination signals of the system (SIGTERM, SIGHUP, and SIGXCPU at a time limit) are
/// recorded instead of ending the program; a second Ctrl-C ends it. Ignored signals stay ignored, such as SIGHUP under
/// nohup.
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

  [[nodiscard]] bool interrupted() const;
};

}  // namespace bumpfoil
