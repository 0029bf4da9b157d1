#pragma once

#include <functional>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// What is computed of a running bearing besides the states of its path.
struct RunningRequest {
  bool all_paths{};  ///< every path that leads to the states, as equilibrium.paths = "all"
  bool limits{};     ///< lift-off speeds and load capacities
};

/// All that the command `equilibrium` reports: run_equilibrium() on the paths that the case names, the errors of the
/// mesh (estimate_mesh_errors()), coefficients for rotor dynamics (tabulate_whirls()), a second path to compare with
/// (EquilibriumResult::other_branches) unless equilibrium.paths says otherwise, and the limits of add_film_limits().
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) as run_equilibrium() and add_film_limits() do
EquilibriumResult analyse_running_bearing(const Case& input, const RunningRequest& request,
                                          const std::function<bool(double)>& progress = {});

/// The standard path that the states of a path are compared with: speed_ramp for a ramp of loads, a position ray or
/// cold starts at positions; the ramp of loads, or the ray to the positions, for all others.
FilmPath second_path(const EquilibriumSettings& equilibrium);

}  // namespace bumpfoil
