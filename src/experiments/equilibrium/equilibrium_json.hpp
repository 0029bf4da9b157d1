#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"

namespace bumpfoil {

/// The quantities of a state, the reason if it was not found, and the last state found on the way.
nlohmann::ordered_json state_json(const BearingModel& bearing, const RunningState& state);

/// The value of a limit and its neighbours, or the reason it was not found.
nlohmann::ordered_json limit_json(const FilmLimit& limit);

}  // namespace bumpfoil
