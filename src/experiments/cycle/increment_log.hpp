#pragma once

#include <functional>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Checks whether W = E - E0 + D holds where required.
class EnergyBalance {
 public:
  explicit EnergyBalance(double force_scale) : force_scale_(force_scale) {}

  /// Adds an increment of known energy.
  void add(const Increment& increment, bool is_linear);

  [[nodiscard]] bool holds() const;

 private:
  double force_scale_;
  double start_{};      ///< E0, J
  double imbalance_{};  ///< J
  double scale_{};      ///< J
  bool must_hold_{true};
};

/// Makes increments of foil steps, and records them.
class IncrementLog {
 public:
  /// @param cycle    receives the record, with `due` given; outlives the log
  /// @param pass_on  called before memory is full, and at the end: the record is cleared afterwards. Without it,
  ///   everything is kept.
  IncrementLog(FoilStepper& stepper, Recording recording, Cycle& cycle, std::function<void()> pass_on = {});

  /// Makes the next increment.
  /// @param direction     unit vector of displacement and direct force
  /// @param displacement  its end; if prescribed, without round-off
  /// @param checked        compute its residual even if not everything is recorded
  Increment make(const Step& step, Branch branch, const Eigen::Vector2d& direction, double displacement, bool checked);

  /// Records it, unless only quantities are requested.
  void write_down(const Step& step, const Increment& increment, const Eigen::Vector2d& direction);

  /// Call after the last increment.
  void finish();

 private:
  [[nodiscard]] const BearingModel& foils() const { return stepper_.foils(); }

  FoilStepper& stepper_;
  bool everything_;
  Cycle& cycle_;
  std::function<void()> pass_on_;
  int capacity_;  ///< number of increments kept in memory
  EnergyBalance balance_;
  int count_{};          ///< number of increments so far
  Eigen::Index rows_{};  ///< of these, number in the cycle with fields
};

}  // namespace bumpfoil
