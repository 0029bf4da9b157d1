#pragma once

#include "bumpfoil/model/case.hpp"
#include "model/judge.hpp"

namespace bumpfoil {

/// Judges what is said of pads beside their foils.
/// @param radius  of the bearing, 0 where that is not usable
/// @return whether they have arcs and places
bool judge_pads(Judge& judge, const Case& input, double radius);

/// Judges whether pads lie beside each other. Their foils must be right.
void judge_overlaps(Judge& judge, const Case& input);

}  // namespace bumpfoil
