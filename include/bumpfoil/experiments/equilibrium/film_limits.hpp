#pragma once

#include <functional>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// Lift-off speed under each load of [equilibrium], coasting down (or running up) from its first speed, and load
/// capacity at each speed, in the direction of its first load: the last state on the path that is as thick as
/// film.h_lift_off and stable with the journal held. A path begins as a load ramp and goes on in steps of a quarter
/// until the film has crossed the threshold; every step is an increment. If none of its states is stable, a load
/// capacity is searched for at smaller loads, down to a tenth of the first. Every step in which the film crosses the
/// threshold, or stability changes, is halved to a thousandth.
/// @param progress  called with the fraction that is done; returning false ends the run
/// @throws Error (input) if the case cannot be built, or has no film.h_lift_off or no loads
std::vector<FilmLimit> run_film_limits(const Case& input, const std::function<bool(double)>& progress = {});

/// Runs them, and adds to each state the limits at its load and its speed. @param result  of run_equilibrium()
void add_film_limits(const Case& input, EquilibriumResult& result, const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
