#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>

namespace bumpfoil {

/// What a run without the lock of the interpreter asks now and then: whether Ctrl-C was pressed, and the caller's own
/// function of the fraction that is done, which stops the run by returning False.
class Watch {
 public:
  /// @param progress  a function of the fraction, or None
  explicit Watch(pybind11::object progress) : progress_(std::move(progress)) {}

  /// To be called without the lock, by one thread. @return whether to go on
  bool go_on(double fraction);

  /// To be called with the lock, when the run is over: what was thrown meanwhile.
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  pybind11::object progress_;
  Clock::time_point next_;
  bool stopped_{};
  std::exception_ptr thrown_;
};

}  // namespace bumpfoil
