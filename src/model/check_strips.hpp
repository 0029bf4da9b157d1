#pragma once

#include "model/check_bump_foil.hpp"

namespace bumpfoil {

/// Checks the strips of a bump foil over the width, and features that strips exclude if they differ.
/// @param foil    of the pad
/// @param radius  of the bearing; 0 if unusable
void check_strips(Checks& checks, const PadDesign& pad, const CheckedBumpFoil& foil, double radius);

}  // namespace bumpfoil
