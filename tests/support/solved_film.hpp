#pragma once

#include <string>

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// The equations of a steady state themselves, judged without any part of what solved them: the film, the foil with its
/// contact forces, the bump foil, and every inequality of the contacts.
/// @return the first that is not met; empty if all are
std::string wrong_film(const FilmBearing& bearing, const BearingState& state);

}  // namespace bumpfoil
