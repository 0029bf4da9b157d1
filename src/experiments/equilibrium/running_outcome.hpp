#pragma once

#include <string_view>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/experiments.hpp"

namespace bumpfoil {

/// Advice to reduce memory.
inline constexpr std::string_view running_advice = "use fewer states or a coarser mesh";

/// Outcome of a run whose results are films.
Outcome running_outcome(const Case& input, EquilibriumResult result);

}  // namespace bumpfoil
