#pragma once

#include <string>
#include <string_view>

#include "bumpfoil/analysis/equilibrium.hpp"

namespace bumpfoil {

/// Contents of coefficients.toml of a running bearing: for each path, load (or position) and kind of small motion the
/// arguments of the constructor of ROSS's BearingElement. With frequencies of the case they are given at these, over
/// the speeds if there are several; else in synchronous whirl, so that each frequency is the speed of its state.
/// Speeds whose state was not found or whose coefficients are not known are left out. docs/rotor_dynamics.md explains
/// them.
std::string film_ross_toml(const Case& input, const EquilibriumResult& result, std::string_view run_id);

}  // namespace bumpfoil
