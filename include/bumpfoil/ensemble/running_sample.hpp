#pragma once

#include <functional>
#include <optional>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Runs the bearing of a sampled case on its film: all states of [equilibrium], along its path. Failures are reported
/// in the states.
/// @param limits  whether lift-off speeds and load capacities are to be found, too
/// @pre  the case has [equilibrium]
/// @return nothing if the case makes no bearing
std::optional<EquilibriumResult> run_running_sample(const Case& sampled,
                                                    const std::function<bool(double)>& progress = {},
                                                    bool limits = false);

}  // namespace bumpfoil
