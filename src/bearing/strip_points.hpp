#pragma once

#include <span>
#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/structure/width_lines.hpp"

namespace bumpfoil {

/// Foils for each strip of the bump foil, with its properties over the whole width.
std::vector<BearingModel> strips_of(const BearingModel& foils);

/// Keeps the stress models of strips of different thickness.
void keep_stress(std::span<const BearingModel> strips, BearingModel& foils);

/// Adds lines and points to foils whose strips move independently. The first line and the bump foil under the first
/// point use the foils' own unknowns of a block, all others those from `further` on.
void lay_out_strips(const WidthLines& width, int further, BearingModel& foils);

/// The same for foils that are split from top to bump: only slices at the points of the strips, the first of which uses
/// the foils' own unknowns.
void lay_out_split_foils(BearingModel& foils);

/// Adds these slices to K. @param strips  of strips_of()
void add_slices(const BearingModel& foils, std::span<const BearingModel> strips, BlockTridiagonal& K);

/// Adds the bump foils under all points to K, and the ties between the top foil displacements there and on the lines.
/// @param strips  of strips_of()
void add_strips(const BearingModel& foils, std::span<const BearingModel> strips, const WidthLines& width,
                BlockTridiagonal& K);

}  // namespace bumpfoil
