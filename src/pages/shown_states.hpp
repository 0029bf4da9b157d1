#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A running bearing as described by report_json, directly from memory: identical to writing and reading files, except
/// for file attributes.
nlohmann::ordered_json shown_states(const Case& input, const EquilibriumResult& result);

/// Free motions of a rotor over speed in the same way.
nlohmann::ordered_json shown_rotor(const Case& input, const StabilityResult& result);

}  // namespace bumpfoil
