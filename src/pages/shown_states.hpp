#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// A running bearing as report_json describes it, out of memory: the same as if it had been written and read back, but
/// for attributes of the file.
nlohmann::ordered_json shown_states(const Case& input, const EquilibriumResult& result);

}  // namespace bumpfoil
