#pragma once

#include <string>
#include <string_view>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// Contents of coefficients.toml of a running bearing: for each path, load (or position) and kind of small motion the
/// arguments of the constructor of ROSS's BearingElement, over the speeds if there are several. Version 3 has them over
/// the tabulated frequencies, and in synchronous whirl beside that; version 2, which knows one axis, in synchronous
/// whirl alone. Speeds whose state was not found or whose coefficients are not known are left out.
/// docs/rotor_dynamics.md explains them.
/// @param result  judged for rotor dynamics, see StateJudges
std::string film_ross_toml(const Case& input, const EquilibriumResult& result, std::string_view run_id);

}  // namespace bumpfoil
