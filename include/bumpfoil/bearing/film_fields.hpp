#pragma once

#include "bumpfoil/bearing/fields.hpp"
#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// The foils of a bearing that runs as foils without a film know them: displacements, gaps, contact forces and modes.
/// The journal touches nothing; its gaps are the film thickness over the crests.
BearingState foil_state(const FilmBearing& bearing, const BearingState& state);

}  // namespace bumpfoil
