#pragma once

#include <functional>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Watches whether W = E - E0 + D holds where it must.
class EnergyBalance {
 public:
  explicit EnergyBalance(double force_scale) : force_scale_(force_scale) {}

  /// An increment whose energy is known.
  void add(const Increment& increment, bool is_linear);

  [[nodiscard]] bool holds() const;

 private:
  double force_scale_;
  double start_{};      ///< E0, J
  double imbalance_{};  ///< J
  double scale_{};      ///< J
  bool must_hold_{true};
};

/// Makes increments of the steps that foils take, and writes them down.
class IncrementLog {
 public:
  /// @param cycle    receives what is written down, `due` filled in; outlives the log
  /// @param pass_on  called ahead of the increment that the memory has no room for, and in the end: what is written
  /// down
  ///                 is forgotten then. Without it all is kept.
  IncrementLog(FoilStepper& stepper, Recording recording, Cycle& cycle, std::function<void()> pass_on = {});

  /// The next increment.
  /// @param direction     unit vector along which displacement and direct force count
  /// @param displacement  where it led; if that was prescribed not a rounding beside it
  /// @param judged        it is to be judged even where not everything is recorded
  Increment make(const Step& step, Branch branch, const Eigen::Vector2d& direction, double displacement, bool judged);

  /// Writes it down, unless quantities alone are wanted.
  void write_down(const Step& step, const Increment& increment, const Eigen::Vector2d& direction);

  /// All have passed.
  void finish();

 private:
  [[nodiscard]] const Foils& foils() const { return stepper_.foils(); }

  FoilStepper& stepper_;
  bool everything_;
  Cycle& cycle_;
  std::function<void()> pass_on_;
  int capacity_;  ///< increments that are kept at a time
  EnergyBalance balance_;
  int count_{};          ///< increments that passed
  Eigen::Index rows_{};  ///< of those in the cycle with fields
};

}  // namespace bumpfoil
