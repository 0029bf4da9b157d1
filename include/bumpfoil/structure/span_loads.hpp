#pragma once

#include "bumpfoil/structure/top_foil.hpp"

namespace bumpfoil {

/// Loads on the crests that displace them as line loads between the crests do, N, outward, one per crest. A line load
/// q (N/m, outward) is constant within each span: from the weld to crest 1, from crest to crest, and from the last
/// crest to the free end. In the moment form of top_foil.hpp
///
///     D M = P + s,   T M = D' u - r
///
/// with s the reactions of simply supported spans and r the rotations of their ends,
///
///     s = q R tan(d/2),   r = (R^3 q / EI') (1 - cos d) (1 - d / sin d) / (2 sin d)      from each neighbouring span
///
/// so that K_t u = P + s + D T^-1 r. Behind the last crest the foil carries M_N = q R^2 (1 - cos d) and the shear
/// q R sin d of the overhang. What the foil does between the crests is not part of these loads: its bending there and
/// the energy it takes are those of the spans alone.
/// @param form       of `beam`
/// @param end_angle  of the free end, at or beyond the last crest, rad
/// @param line_load  one entry per span, crests + 1 in all, N/m
Vector crest_loads(const TopFoilBeam& beam, const TopFoilMoments& form, double end_angle, const Vector& line_load);

}  // namespace bumpfoil
