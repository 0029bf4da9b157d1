#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// Runs the bearing of a sampled case on its film: all states of [equilibrium], along its path. Failures are reported
/// in the states.
/// @param limits  whether lift-off speeds and load capacities are to be found, too
/// @pre  the case has [equilibrium]
/// @return nothing if the case makes no bearing
std::optional<EquilibriumResult> run_running_sample(const Case& sampled,
                                                    const std::function<bool(double)>& progress = {},
                                                    bool limits = false);

/// What ensembles keep of a rotor: of the result of its command the numbers of the run as a whole that are sampled, the
/// status of the run first.
std::vector<const Variable*> sampled_variables(const Dataset& run);

/// Runs the rotor of a sampled case, all of whose bearings are that of the case, as the command of this name does.
/// @return the values of sampled_variables(); nothing if the case makes no bearing
std::optional<std::vector<double>> run_rotor_sample(const Case& sampled, EnsembleCommand command,
                                                    const std::function<bool(double)>& progress = {});

}  // namespace bumpfoil
