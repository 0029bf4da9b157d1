#pragma once

#include "bumpfoil/bearing/bearing_state.hpp"
#include "bumpfoil/bearing/tangents.hpp"
#include "bumpfoil/contact/residual.hpp"

namespace bumpfoil {

enum class Branch { loading, unloading };

/// One increment of a cycle: where it is, forces and energies. Of an increment that failed only its place is known;
/// the rest is not a number then.
struct Increment {
  int index{};
  Branch branch{Branch::loading};
  double displacement{};        ///< of the journal along the direction, m
  double x{}, y{};              ///< its position, m
  double force_x{}, force_y{};  ///< applied force, N
  double force_direct{};        ///< F.n, N
  double force_cross{};         ///< F.t with t = n turned by +90 deg, N
  double moment_x{};            ///< of the applied forces along X about the mid-plane, int z dF, N m
  double moment_y{};            ///< along Y
  double tilt_x{}, tilt_y{};    ///< slope of the axis of the journal towards X and Y, rad
  double elastic_energy{};      ///< J
  double dissipated_energy{};   ///< since increment 0, J; at increment 0 that of the assembly is kept apart
  double work{};                ///< of the journal since increment 0, trapezoidal rule, J
  ContactResiduals residuals;
  Status status{Status::converged};
  SolveCost cost;
  int substeps{};            ///< extra solves because the increment had to be halved
  int orbit{};               ///< of a path: which of its orbits this belongs to, from 1; 0 before
  TangentMatrices tangents;  ///< of a path

  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// Position and forces of a state along the unit vector `direction`, work and dissipation, and how the step to it
/// ended. Index and branch are left to the caller, energy and residuals not a number: check_increment() finds them.
Increment place_increment(const BearingModel& foils, const Step& step, const Eigen::Vector2d& direction);

/// Fills in elastic energy and residuals of a state.
void check_increment(const BearingModel& foils, const BearingState& state, Increment& increment);

/// An increment that failed before the place of `step`: everything that is not known is not a number.
Increment failed_increment(const Step& step, const Eigen::Vector2d& direction);

}  // namespace bumpfoil
