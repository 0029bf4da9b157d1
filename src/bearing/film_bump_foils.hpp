#pragma once

#include <vector>

#include "bumpfoil/bearing/film_bearing.hpp"

namespace bumpfoil {

/// Places in the block of a bump, line after line. @param further  where those of the second begin
std::vector<CrestLine> crest_lines_of(const WidthLines& lines, const BumpDofs& dofs, int further);

/// K of a running bearing: its bump foils, and what the crests have against displacements that vary over the width. The
/// top foils have nodes at all columns instead, and are no part of it.
/// @param bearing  with its pads and crest lines
BlockTridiagonal bump_foils_alone(const FilmBearing& bearing);

}  // namespace bumpfoil
