#pragma once

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// How far a state is from solving the contact problem. Computed from displacements and forces alone, independently of
/// solvers, modes and penalties. Forces are divided by max(largest contact force, 1 N).
struct ContactResiduals {
  double equilibrium{};      ///< largest entry of elastic forces - load - contact forces, normalised
  double penetration{};      ///< largest -g, m
  double slip_in_stick{};    ///< largest |du| of a contact whose friction force is inside the cone, m
  double complementarity{};  ///< largest tension, or compression across an open gap, normalised
  double cone{};             ///< largest |t| - f p, or friction that does not oppose the slip, normalised

  /// The bounds that a solution meets: forces to `force`, displacements to `displacement` (m).
  [[nodiscard]] bool within(double force = 1e-9, double displacement = 1e-12) const {
    // Negated so that a NaN fails.
    return equilibrium <= force && complementarity <= force && cone <= force && penetration <= displacement &&
           slip_in_stick <= displacement;
  }
};

/// Gaps and slips below this count as zero where forces are checked, m: above the round-off of displacements of about
/// 0.1 mm in foils whose condition number reaches 1e9.
inline constexpr double displacement_resolution = 1e-12;

/// Checks a state.
/// @param problem          sites and friction coefficients
/// @param elastic_force    K x or e(x), N, without any part of the solver: see elastic_response in structure/
/// @param loading          initial gaps and loads
/// @param previous_x       unknowns at the last converged increment, which slip is measured from
/// @param state displacements and forces to check
ContactResiduals contact_residuals(const ContactProblem& problem, const Vector& elastic_force,
                                   const ContactLoading& loading, const Vector& previous_x, const ContactState& state);

}  // namespace bumpfoil
