#pragma once

#include <functional>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// The bearing of a case with a wall of film.wall in place of its foils, closed or with the slot at the weld: mesh,
/// scales and angles alone.
/// @throws Error (input) if the case is wrong
BearingModel make_wall_bearing(const Case& input);

/// Finds the films at all speeds and positions of [equilibrium] over that wall, each by itself: from the centred
/// journal the wall is followed to the position in steps of adapted length. There is one film for each, whatever the
/// path; stiffnesses are absent.
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) if the case is wrong, or has no positions
EquilibriumResult run_wall_films(const Case& input, const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
