#pragma once

#include "bumpfoil/bearing/fields.hpp"
#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// The foils of a bearing that runs as foils without a film know them: displacements, gaps, contact forces and modes.
/// The journal touches nothing; its gaps are the film thickness over the crests.
FoilState foil_state(const FilmBearing& bearing, const FilmBearingState& state);

}  // namespace bumpfoil
