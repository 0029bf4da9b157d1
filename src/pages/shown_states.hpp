#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A running bearing as report_json describes it, out of memory: the same as if it had been written and read back, but
/// for attributes of the file.
nlohmann::ordered_json shown_states(const Case& input, const EquilibriumResult& result);

/// Free motions of a rotor over speed in the same way.
nlohmann::ordered_json shown_rotor(const Case& input, const StabilityResult& result);

}  // namespace bumpfoil
