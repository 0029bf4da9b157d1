#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "bumpfoil/bearing/backward_difference.hpp"
#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// Unknowns of a rotor and their rates.
struct RotorMotion {
  Eigen::VectorXd y, v;
};

/// A rotor and its bearings at an instant, with everything that a step in time passes to the next: a march continued
/// from a copy is bit-identical. A plain value.
struct MachineState {
  double time{};   ///< s
  double angle{};  ///< through which the rotor has turned, rad
  double speed{};  ///< Omega, rad/s
  RotorMotion rotor;
  std::vector<BearingState> bearings{};  ///< in the order of Rotor::bearings, each journal where the rotor is
  double last_dt{};                      ///< length of the last step, s; 0: there was none
  RotorMotion rotor_before{};            ///< at its start
  std::vector<BearingState> bearings_before{};
};

/// Where a rotor is in its turn.
struct RotorInstant {
  double time{};          ///< s
  double angle{};         ///< rad
  double speed{};         ///< Omega, rad/s
  double acceleration{};  ///< dOmega/dt, rad/s^2
};

/// Known forces f on the unknowns of a rotor: weight, unbalance, impulses, inertia of a base that moves.
using RotorForces = std::function<Eigen::VectorXd(const RotorInstant&)>;

/// How long a step in time is, and the speed at its end: from the one at its start it changes evenly.
struct TimeStep {
  double dt{};     ///< s
  double speed{};  ///< Omega, rad/s
  /// Implicit Euler shows what is lost by it: benchmarks.
  TimeScheme scheme{TimeScheme::bdf2};
};

/// How a step in time ended and what it cost.
struct MachineReport {
  Status status{Status::not_converged};
  int iterations{};      ///< of Newton's method, all parts together
  int factorisations{};  ///< of contact systems
  int parts{};           ///< equal ones that the step was taken in
};

/// Advances a rotor on any number of bearings in time by BDF2,
///
///     M dv/dt + (Omega G + C) v + K y = f - sum B_i^T F_i,      v = dy/dt
///
/// with film, foils, unilateral contact and Coulomb friction of all bearings and the rotor in one system at the end of
/// each step; the increments of friction are the steps. The first step is one of implicit Euler. A step that Newton's
/// method fails to find is taken again in 2, 4, ... 128 equal parts. One thread at a time.
class MachineStepper {
 public:
  /// @param bearings  in the order of Rotor::bearings, none twice: they may share a BearingModel. They outlive this
  MachineStepper(Rotor rotor, std::vector<FilmStepper*> bearings);

  /// A machine whose bearings carry the rotor in these states, all at one speed: nothing moves.
  /// @param forces  f in equilibrium, which bends a shaft between its bearings
  [[nodiscard]] MachineState at_rest(std::vector<BearingState> states, const Eigen::VectorXd& forces) const;

  /// @param state  receives the result; stays as it was unless the status is converged. Statuses touchdown,
  ///               not_converged, interrupted
  [[nodiscard]] MachineReport advance(const TimeStep& step, const RotorForces& forces, MachineState& state);

  [[nodiscard]] const Rotor& rotor() const { return rotor_; }
  [[nodiscard]] const std::vector<FilmStepper*>& bearings() const { return bearings_; }
  /// Where y of the rotor puts the journals of the bearings, see JointLaw::Journal.
  [[nodiscard]] const std::vector<JointLaw::Journal>& journals() const { return law_.journals; }

 private:
  FilmReport take(const TimeStep& step, const RotorForces& forces, MachineState& state);
  [[nodiscard]] JointMove move_of(const TimeStep& step, const BackwardDifference& rate, const RotorMotion& reference,
                                  const Eigen::VectorXd& forces) const;
  void guess(double dt, const MachineState& state, Eigen::VectorXd& y);

  Rotor rotor_;
  std::vector<FilmStepper*> bearings_;
  JointLaw law_;  ///< without what the step of time decides
  std::vector<BearingState> guesses_, ends_;
};

}  // namespace bumpfoil
