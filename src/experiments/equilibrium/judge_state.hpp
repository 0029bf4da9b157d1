#pragma once

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// Adds to a state what follows from it. With a stepper of its own: the walk may be on to the next state.
void judge_state(const SharedFilmBearing& bearing, const EquilibriumSettings& settings, RunningState& found);

}  // namespace bumpfoil
