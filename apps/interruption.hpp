#pragma once

namespace bumpfoil {

/// While it lives, Ctrl-C is noted instead of ending the program; a second one ends it.
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

  [[nodiscard]] bool interrupted() const;
};

}  // namespace bumpfoil
