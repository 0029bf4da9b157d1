#pragma once

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// Adds derived results to a state, with a stepper of its own: the walk may already be at the next state.
/// @param tabulates  whether to add results for rotor dynamics
void check_state(const SharedBearing& bearing, const EquilibriumSettings& settings, bool tabulates,
                 RunningState& found);

}  // namespace bumpfoil
