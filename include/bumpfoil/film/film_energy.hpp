#pragma once

#include "bumpfoil/film/reynolds.hpp"

namespace bumpfoil {

/// Powers of a film over the whole width: residuals of reynolds_residual() times ln P, summed by parts. For the fluxes
/// of that scheme, whatever they are, and any motion of the foils,
///
///     entrained + supplied = dissipated + d(free energy)/dt + 2 T0 sum of areas (P - 1) dH/dt
///
/// holds exactly between steps in time: the last term is the work that the film does on what bounds it. In units of
/// pa^2 c^3 / (12 mu), T0 in that of t.
struct FilmPowers {
  double entrained{};   ///< done by the moving surface on the gas that it draws along: sum of w Lam psi_f D ln P
  double dissipated{};  ///< by the flow under gradients of pressure: sum of w G (D P / dx) D ln P, both directions
  double supplied{};    ///< by gas that enters at edges where P is not 1
};

/// @param equation  steady
FilmPowers film_powers(const ReynoldsEquation& equation, const FilmState& film);

/// Isothermal free energy of the gas relative to ambient pressure, int [P ln P - (P - 1)] H dA of the whole width, in
/// units of pa R^2 c. Edges where P is given keep what enters there out of it: they have - (P - 1) H alone.
double free_energy(const FilmMesh& mesh, const FilmState& film);

}  // namespace bumpfoil
