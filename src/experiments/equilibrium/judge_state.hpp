#pragma once

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// Adds to a state what follows from it. With a stepper of its own: the walk may be on to the next state.
/// @param tabulates  whether to add what is for rotor dynamics
void judge_state(const SharedFilmBearing& bearing, const EquilibriumSettings& settings, bool tabulates,
                 RunningState& found);

}  // namespace bumpfoil
