#pragma once

#include <string>
#include <vector>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "results/result_grid.hpp"

namespace bumpfoil {

/// What sweeps keep of running bearings: their quantities over speed and load, or speed and position.
ResultGrid equilibrium_grid(const EquilibriumSettings& settings, const EquilibriumResult& result);

/// Where the grid has a state of the result.
std::size_t place_of(const EquilibriumSettings& settings, std::size_t state);

/// A result of which no state was looked for.
EquilibriumResult equilibrium_not_begun(const Case& input);

}  // namespace bumpfoil
