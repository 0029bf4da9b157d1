#pragma once

#include "bumpfoil/experiments/sampling.hpp"

namespace bumpfoil {

/// Running bearings of an ensemble: a place for each state of [equilibrium], reached along its path alone, with
/// lift-off speeds and load capacities where montecarlo.limits asks for them.
Sampling equilibrium_sampling();

}  // namespace bumpfoil
