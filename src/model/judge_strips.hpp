#pragma once

#include "model/judge_bump_foil.hpp"

namespace bumpfoil {

/// The strips that a bump foil is split into over the width, and what cannot be done with those that differ.
/// @param foil    of the pad
/// @param radius  of the bearing, 0 where that is not usable
void judge_strips(Judge& judge, const PadDesign& pad, const JudgedBumpFoil& foil, double radius);

}  // namespace bumpfoil
