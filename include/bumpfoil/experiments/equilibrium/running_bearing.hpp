#pragma once

#include <functional>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// All that the command `equilibrium` reports: run_equilibrium() on the paths that the case names, checked for rotor
/// dynamics, too, the errors of the mesh (estimate_mesh_errors()), a second path to compare with
/// (EquilibriumResult::other_branches) unless equilibrium.paths says otherwise, and the limits of add_film_limits()
/// where equilibrium.limits asks for them.
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) as run_equilibrium() and add_film_limits() do
EquilibriumResult analyse_running_bearing(const Case& input, const std::function<bool(double)>& progress = {});

/// The standard path that the states of a path are compared with: speed_ramp for a ramp of loads, a position ray or
/// starts from ambient pressure at positions; the ramp of loads, or the ray to the positions, for all others.
FilmPath second_path(const EquilibriumSettings& equilibrium);

}  // namespace bumpfoil
