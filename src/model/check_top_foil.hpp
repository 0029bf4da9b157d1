#pragma once

#include "bumpfoil/model/bearing_design.hpp"
#include "model/judge.hpp"
#include "model/judge_bump_foil.hpp"

namespace bumpfoil {

/// Checks forming and overhang of the top foil of a pad, or of a bearing without pads.
/// @param foil    known properties of its bump foil
/// @param radius  of the bearing, m; 0 if unusable
void judge_top_foil(Judge& judge, const PadDesign& pad, const JudgedBumpFoil& foil, double radius);

}  // namespace bumpfoil
