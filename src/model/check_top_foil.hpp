#pragma once

#include "bumpfoil/model/bearing_design.hpp"
#include "model/check_bump_foil.hpp"
#include "model/checks.hpp"

namespace bumpfoil {

/// Checks forming and overhang of the top foil of a pad, or of a bearing without pads.
/// @param foil    known properties of its bump foil
/// @param radius  of the bearing, m; 0 if unusable
void check_top_foil(Checks& checks, const PadDesign& pad, const CheckedBumpFoil& foil, double radius);

}  // namespace bumpfoil
