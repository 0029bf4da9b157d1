#pragma once

#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"

namespace bumpfoil {

/// The foils of a bearing under a static load, and their response to vibrations about it.
class LoadedFoils {
 public:
  /// @throws Error (input) if the case cannot be built
  explicit LoadedFoils(const Case& input);

  /// Takes the unstressed foils to a load.
  StaticLoad go_to(const Eigen::Vector2d& load);

  /// Vibrates along a line about the last load until the loop has settled; starts from a copy of the loaded state.
  /// @pre  the load was reached
  Cycle vibrate(double direction, double amplitude, const ProgressCallback& progress = {});

  [[nodiscard]] FoilStepper& stepper() { return stepper_; }
  [[nodiscard]] double reach() const { return reach_; }                      ///< limit of the search for loads, m
  [[nodiscard]] const BearingState& state() const { return loaded_.state; }  ///< at the last load

 private:
  int steps_;
  FoilStepper stepper_;
  double reach_;
  Eigen::Vector2d load_{0.0, 0.0};
  Step loaded_;  ///< the step that reached the last load
};

}  // namespace bumpfoil
