#pragma once

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// The lines over the width with the places of their unknowns in a block: of the first in the places of the foils'
/// unknowns, of the others from `further` on. Top foil and crest have unknowns of their own on every line; the rest of
/// the bump foil where a mode is linear over the width, as that slides and lifts its feet, too.
std::vector<FoilLine> foil_lines_of(const WidthLines& lines, const BumpDofs& dofs, int further);

/// K of the bump foils on these lines, with the places that FilmBearing says. Modes that are uniform or linear over the
/// width displace all of a bump foil, and each of its slices is the bump foil there; against modes of a higher order
/// the crest has springs, and nothing slides or lifts. @param bearing  complete but for its problem
BlockTridiagonal bump_foils_alone(const FilmBearing& bearing);

}  // namespace bumpfoil
