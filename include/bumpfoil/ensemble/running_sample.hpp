#pragma once

#include <functional>
#include <optional>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/experiments/unbalance/unbalance.hpp"
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

/// Runs the rotor of a sampled case, all of whose bearings are that of the case, over the speeds of [stability].
/// Failures are reported at the speeds.
/// @return nothing if the case makes no bearing
std::optional<StabilityResult> run_rotor_sample(const Case& sampled, const std::function<bool(double)>& progress = {});

/// The same for its response to unbalance, over the speeds of [unbalance].
std::optional<UnbalanceResult> run_unbalance_sample(const Case& sampled,
                                                    const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
