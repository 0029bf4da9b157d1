#pragma once

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// Energies of a piece of the response: between two states in balance, with loading and contact forces p, t that change
/// linearly from one to the other. With W the work of all that drives the problem, E = x'K x / 2 and the slips dw,
///
///     given_off = W - (E_end - E_begin) = - sum of p dg + t dw,    friction = sum of f p |dw|,    p and t halfway
struct PieceEnergy {
  double given_off{};  ///< by the elastic bodies and what drives them, J
  double friction{};   ///< what Coulomb friction dissipates where contacts slip throughout, J

  /// Zero to round-off if no contact changes its mode on the way; otherwise a measure of the nonlinearity of the
  /// response there or, at constant loading, of a jump, J.
  [[nodiscard]] double defect() const { return given_off - friction; }
};

/// Only for linear elastic forces.
PieceEnergy piece_energy(const ContactProblem& problem, const ContactState& begin, const ContactState& end);

/// Energies up to this size are within round-off and tolerances of the two states, J: 1e-11 of the elastic energy, or
/// what the largest contact force does on 1e-14 m.
double negligible_energy(const ContactProblem& problem, const ContactState& begin, const ContactState& end);

}  // namespace bumpfoil
