#pragma once

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/model/case.hpp"
#include "results/result_grid.hpp"

namespace bumpfoil {

/// What result.nc has of running bearings: everything known of every state, its film, bumps and feet, and the geometry.
/// Of states that were not found all is absent but what was asked for.
ResultGrid state_grid(const Case& input, const EquilibriumResult& result);

}  // namespace bumpfoil
