#pragma once

#include "bumpfoil/model/case.hpp"
#include "model/judge.hpp"

namespace bumpfoil {

/// Properties of a bump foil that other checks need.
struct JudgedBumpFoil {
  bool bumps{};    ///< their number is usable
  bool pitches{};  ///< as well as all pitches
  double rise{};   ///< of the mid-surface of the tallest nominal bump, m; 0 where it is not known
};

/// Checks the shape of a bump foil, its lists and its shims, not its material.
/// @param radius  of the bearing, 0 where that is not usable
JudgedBumpFoil judge_bump_foil(Judge& judge, const BumpFoil& foil, double radius);

/// Checks whether lists and gradings along the foil cover a strip of so many bumps.
void judge_strip_of(Judge& judge, const BumpFoil& foil, int bumps);

}  // namespace bumpfoil
