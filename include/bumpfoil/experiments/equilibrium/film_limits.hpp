#pragma once

#include <functional>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// Lift-off speed under each load of [equilibrium], coasting down (or running up) from its first speed, and load
/// capacity at each speed, in the direction of its first load. A path begins as a load ramp, goes on in steps of a
/// quarter until the film has crossed the threshold, and halves the last step to a thousandth; every step is an
/// increment.
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) if the case cannot be built, or has no film.h_lift_off or no loads
std::vector<FilmLimit> run_film_limits(const Case& input, const std::function<bool(double)>& progress = {});

/// Runs them, and says of each state the limits at its load and its speed. @param result  of run_equilibrium()
void add_film_limits(const Case& input, EquilibriumResult& result, const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
