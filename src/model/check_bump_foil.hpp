#pragma once

#include "bumpfoil/model/case.hpp"
#include "model/checks.hpp"

namespace bumpfoil {

/// Properties of a bump foil that other checks need.
struct CheckedBumpFoil {
  bool bumps{};    ///< whether their number is usable
  bool pitches{};  ///< whether all pitches are, too
  double rise{};   ///< of the mid-surface of the tallest nominal bump, m; 0 if unknown
};

/// Checks the shape of a bump foil, its lists and its shims, not its material.
/// @param radius  of the bearing; 0 if unusable
CheckedBumpFoil check_bump_foil(Checks& checks, const BumpFoil& foil, double radius);

/// Checks whether lists and gradings along the foil match the number of bumps of a strip.
void check_strip_of(Checks& checks, const BumpFoil& foil, int bumps);

}  // namespace bumpfoil
