#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// The quantities of a state, why it was not found, and the last one that was found on the way.
nlohmann::ordered_json state_json(const FilmBearing& bearing, const RunningState& state);

/// Where a limit lies, between which neighbours, or why it was not found.
nlohmann::ordered_json limit_json(const FilmLimit& limit);

}  // namespace bumpfoil
