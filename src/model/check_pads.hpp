#pragma once

#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/pads.hpp"
#include "model/checks.hpp"

namespace bumpfoil {

/// Checks pads, except their foils.
/// @param radius  of the bearing; 0 if unusable
/// @return whether their arcs and positions are known
bool check_pads(Checks& checks, const Case& input, double radius);

/// Checks that pads do not overlap. Their foils must be valid.
void check_overlaps(Checks& checks, const Case& input, const std::vector<PlacedPad>& pads);

}  // namespace bumpfoil
