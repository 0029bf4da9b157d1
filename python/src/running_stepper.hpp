#pragma once

#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <memory>
#include <mutex>
#include <optional>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/core/status.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A state of a running bearing as it was reached, with what is known of it. A plain value, never changed.
struct ReachedInstant {
  BearingState state;
  FilmBearingOutcome outcome;
  Status status{Status::converged};
  double span{};  ///< BackwardDifference::span of the step that led to it, s; 0: there was none
};
using SharedInstant = std::shared_ptr<const ReachedInstant>;

/// A running bearing, taken through time by BDF2 while others hold its journal. Several threads may call it, one after
/// the other.
class RunningStepper {
 public:
  /// @throws Error (input) if the case cannot be built
  explicit RunningStepper(const Case& input);
  /// Shares the bearing.
  RunningStepper(const RunningStepper& other);
  RunningStepper& operator=(const RunningStepper&) = delete;
  ~RunningStepper() = default;

  /// The equilibrium at a speed, along the path of [equilibrium].
  SharedInstant begin(const OperatingPoint& point);
  /// A step in time (s), one increment of friction.
  SharedInstant advance(const ReachedInstant& from, double dt, const OperatingPoint& to);
  /// dF/d(x, y) at the end of the step that led there, N/m, its start held; of an equilibrium its stiffness.
  [[nodiscard]] std::optional<Eigen::Matrix2d> tangent(const ReachedInstant& instant);
  [[nodiscard]] const BearingModel& bearing() const { return *bearing_; }

 private:
  Case input_;
  SharedBearing bearing_;
  FilmStepper stepper_;
  std::mutex mutex_;
};

/// Adds RunningStepper and ReachedInstant to the module.
void add_running_stepper(pybind11::module_& m);

}  // namespace bumpfoil
