#pragma once

#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/pads.hpp"
#include "model/judge.hpp"

namespace bumpfoil {

/// Checks pads, except their foils.
/// @param radius  of the bearing; 0 if unusable
/// @return whether their arcs and positions are known
bool judge_pads(Judge& judge, const Case& input, double radius);

/// Checks that pads do not overlap. Their foils must be valid.
void judge_overlaps(Judge& judge, const Case& input, const std::vector<PlacedPad>& pads);

}  // namespace bumpfoil
