#pragma once

#include <span>
#include <vector>

#include "bumpfoil/bearing/foils.hpp"
#include "bumpfoil/structure/width_lines.hpp"

namespace bumpfoil {

/// For each strip of the bump foil, foils that are as it is all over the width.
std::vector<Foils> strips_of(const Foils& foils);

/// Keeps the stress models of strips that differ in thickness.
void keep_stress(std::span<const Foils> strips, Foils& foils);

/// Gives foils whose strips move each by itself their lines and points. The first line and the bump foil under the
/// first point have the places of the foils' unknowns in a block, all others the places from `further` on.
void lay_out_strips(const WidthLines& width, int further, Foils& foils);

/// The same for foils that are split from top to bump: slices at the points of the strips alone, the first in the
/// places of the foils' unknowns.
void lay_out_split_foils(Foils& foils);

/// Adds these slices to K. @param strips  of strips_of()
void add_slices(const Foils& foils, std::span<const Foils> strips, BlockTridiagonal& K);

/// Adds the bump foils under all points to K, and what ties the displacements of the top foil there to those of the
/// lines. @param strips  of strips_of()
void add_strips(const Foils& foils, std::span<const Foils> strips, const WidthLines& width, BlockTridiagonal& K);

}  // namespace bumpfoil
