#pragma once

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil {

/// What a run has to show whose results are films.
/// @param ross_version  see equilibrium_files()
Outcome running_outcome(const Case& input, EquilibriumResult result, int ross_version = 3);

}  // namespace bumpfoil
