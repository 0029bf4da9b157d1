#pragma once

#include <memory>

#include "bumpfoil/motion/machine.hpp"

namespace bumpfoil {

/// Energy that drives a machine over some time, and how it is dissipated and stored, J:
///
///     entrained + supplied + forces + rubbing = dissipated + friction + damping + stored
///
/// exact in space, see FilmPowers; the defect is the error of the steps in time. The drag of the films on the surfaces
/// that move at Omega R (Couette) is not part of it: it is dissipated on the spot.
struct WorkBalance {
  double entrained{};   ///< work of the turning journals on the gas that they draw along
  double supplied{};    ///< by gas that enters at edges above ambient pressure
  double forces{};      ///< work of the known forces on the rotor: weight, unbalance, impulses
  double rubbing{};     ///< work on the rotor's motion by the friction of asperities on the journals
  double dissipated{};  ///< by the flow of the films under gradients of pressure
  double friction{};    ///< between foils and sleeve
  double damping{};     ///< of the rotor itself
  double stored{};      ///< change of the energy of motion, of shaft, films, foils and asperities

  /// Work of the films on their surfaces, stored energy of the gas included.
  [[nodiscard]] double films() const { return entrained + supplied - dissipated; }
  [[nodiscard]] double defect() const { return films() + forces + rubbing - friction - damping - stored; }
  WorkBalance& operator+=(const WorkBalance& other);
};

/// Balances the energy of a machine step by step, with the trapezoidal rule for powers and forces.
class EnergyMeter {
 public:
  /// @param stepper  outlives this, as do the forces
  EnergyMeter(const MachineStepper& stepper, RotorForces forces, const MachineState& start);

  ~EnergyMeter();

  /// The balance of a step that led to `end`, from where the one before ended.
  WorkBalance step_to(const MachineState& end);

 private:
  struct Instant;

  const MachineStepper& stepper_;
  RotorForces forces_;
  std::unique_ptr<Instant> last_;
};

}  // namespace bumpfoil
