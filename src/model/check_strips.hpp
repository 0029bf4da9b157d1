#pragma once

#include "model/judge_bump_foil.hpp"

namespace bumpfoil {

/// Checks the strips of a bump foil over the width, and features that strips exclude if they differ.
/// @param foil    of the pad
/// @param radius  of the bearing; 0 if unusable
void judge_strips(Judge& judge, const PadDesign& pad, const JudgedBumpFoil& foil, double radius);

}  // namespace bumpfoil
