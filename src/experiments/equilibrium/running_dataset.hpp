#pragma once

#include <cstddef>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// Contents of result.nc for running bearings: everything known of every state, its film, bumps and feet, and the
/// geometry. Of states that were not found all is absent but what was asked for.
Dataset state_dataset(const Case& input, const EquilibriumResult& result);

/// Contents of sweeps of running bearings: their quantities over speed and load, or speed and position.
Dataset equilibrium_dataset(const EquilibriumSettings& settings, const EquilibriumResult& result);

/// Where that has a state of the result.
std::size_t place_of(const EquilibriumSettings& settings, std::size_t state);

/// A result of which no state was looked for.
EquilibriumResult equilibrium_not_begun(const Case& input);

}  // namespace bumpfoil
