#pragma once

#include <string>

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// Checks the equations of a steady state independently of the solver: the film, the foil with its contact forces, the
/// bump foil, and every inequality of the contacts.
/// @return the first violation; empty if there is none
std::string wrong_film(const BearingModel& bearing, const BearingState& state);

}  // namespace bumpfoil
