#pragma once

#include <string>
#include <string_view>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// Contents of coefficients.toml of a running bearing: for each path, load (or position) and kind of small motion, the
/// arguments of the constructor of ROSS's BearingElement, over the speeds if there are several. Version 3 has them over
/// the tabulated frequencies, and also for synchronous whirl; version 2, which supports a single axis, for synchronous
/// whirl only. Speeds without a state or coefficients are omitted. See docs/rotor_dynamics.md.
/// @param result  with results for rotor dynamics, see StateCheckers
std::string film_ross_toml(const Case& input, const EquilibriumResult& result, std::string_view run_id);

}  // namespace bumpfoil
