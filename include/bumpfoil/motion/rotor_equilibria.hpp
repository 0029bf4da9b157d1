#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/core/status.hpp"
#include "bumpfoil/motion/whirl.hpp"
#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// Equilibria of the bearings of a rotor under its weight, from speed to speed. Bearings that resist inclinations take
/// moments, too: with K y = f - sum B_i^T F_i they share the weight by how the rotor tilts and bends on them.
class RotorEquilibria {
 public:
  /// @param steppers  of the bearings in the order of Rotor::bearings; they outlive this
  /// @param gravity   m/s^2; each bearing must carry something
  RotorEquilibria(const Rotor& rotor, std::vector<FilmStepper*> steppers, const Eigen::Vector2d& gravity);

  /// Loads on the bearings by the weight alone, N: where they take no moments.
  [[nodiscard]] const std::vector<Eigen::Vector2d>& loads() const { return loads_; }

  /// To a speed (rad/s), in one increment of each bearing; from ambient pressure where there are no states yet.
  /// @param states  of the bearings, receive the result; only those of bearings behind one that fails stay as they were
  Status go_to(double speed, std::vector<BearingState>& states) const;

  /// The bearings in these states, which outlive what is returned.
  [[nodiscard]] std::vector<CarryingBearing> carrying(const std::vector<BearingState>& states) const;

 private:
  [[nodiscard]] FilmReport start(std::size_t bearing, double speed, BearingState& state) const;
  [[nodiscard]] OperatingPoint next_point(std::size_t bearing, double speed, const BearingState& state) const;
  [[nodiscard]] FilmReport join(double speed, std::vector<BearingState>& states) const;

  Rotor rotor_;
  Eigen::VectorXd weight_;  ///< f, N
  std::vector<FilmStepper*> steppers_;
  JointLaw law_;  ///< without A and y*
  std::vector<Eigen::Vector2d> loads_;
};

}  // namespace bumpfoil
