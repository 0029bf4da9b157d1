#include "watch.hpp"

namespace bumpfoil {
namespace {

namespace py = pybind11;

/// Seldom enough to cost nothing, often enough for people.
constexpr std::chrono::milliseconds period{50};

}  // namespace

bool Watch::go_on(double fraction) {
  if (stopped_) return false;
  if (Clock::now() < next_ && fraction < 1.0) return true;
  const py::gil_scoped_acquire lock;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress_.is_none()) stopped_ = progress_(fraction).is(py::bool_(false));
  } catch (const py::error_already_set&) {
    thrown_ = std::current_exception();
    stopped_ = true;
  }
  next_ = Clock::now() + period;
  return !stopped_;
}

}  // namespace bumpfoil
