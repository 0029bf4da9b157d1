#pragma once

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil {

/// Outcome of a run whose results are films.
Outcome running_outcome(const Case& input, EquilibriumResult result);

}  // namespace bumpfoil
