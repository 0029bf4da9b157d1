#pragma once

#include "bumpfoil/contact/problem.hpp"

namespace bumpfoil {

/// Energies of a piece of the response: between two equilibrium states, with loading and contact forces p, t that vary
/// linearly in between. With W the external work, E = x'K x / 2 and the slips dw,
/// |     given_off = W - (E_end - E_begin) = - sum of p dg + t dw,    friction = sum of f p |dw|,    p and t halfway
struct PieceEnergy {
  double given_off{};  ///< energy released by the elastic bodies and their drive, J
  double friction{};   ///< dissipated by Coulomb friction if contacts slip throughout, J

  /// Zero to round-off if no contact changes its mode on the way; otherwise a measure of the nonlinearity of the
  /// response there or, at constant loading, of a jump, J.
  [[nodiscard]] double defect() const { return given_off - friction; }
};

/// Only for linear elastic forces.
PieceEnergy piece_energy(const ContactProblem& problem, const ContactState& begin, const ContactState& end);

/// Energy within round-off and tolerances of the two states, J: 1e-11 of the elastic energy, or the work of the largest
/// contact force over 1e-14 m.
double negligible_energy(const ContactProblem& problem, const ContactState& begin, const ContactState& end);

}  // namespace bumpfoil
