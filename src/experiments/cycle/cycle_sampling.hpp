#pragma once

#include "bumpfoil/experiments/sampling.hpp"

namespace bumpfoil {

/// Cycles of the bearings of an ensemble: a place for each direction.
Sampling cycle_sampling();

}  // namespace bumpfoil
