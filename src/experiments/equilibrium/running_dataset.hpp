#pragma once

#include <cstddef>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// Contents of result.nc for running bearings: all results of every state, its film, bumps and feet, and the geometry.
/// States that were not found only have their requested values.
Dataset state_dataset(const Case& input, const EquilibriumResult& result);

/// Contents of sweeps of running bearings: their quantities over speed and load, or speed and position.
Dataset equilibrium_dataset(const EquilibriumSettings& settings, const EquilibriumResult& result);

/// Index of a state of the result in it.
std::size_t place_of(const EquilibriumSettings& settings, std::size_t state);

/// A result in which no state has been computed.
EquilibriumResult equilibrium_not_begun(const Case& input);

}  // namespace bumpfoil
