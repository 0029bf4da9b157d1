#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "bumpfoil/model/bearing_design.hpp"

namespace bumpfoil {

/// A single pad.
struct PlacedPad {
  PadDesign alone;                   ///< the bearing as if this were all its foils
  Eigen::Vector2d centre{0.0, 0.0};  ///< of the circle of the pad, m: the bearing's, displaced away from its middle
};

/// The pads of a bearing; without any, all of it is one. The bearing of pad k of n has
///
///     foils: its own, or the common ones; their pitches stretched to its arc
///     arc: its own, or 2 pi / n - pad_gap, or what its pitches add up to
///     weld: its own, or where pad 1 to k - 1 have had their share: weld_angle -+ 2 pi (k - 1) / n, and by the arc
///           further on where it is welded at its trailing edge; there it runs against `Bearing::wrap`
///
/// The design must be valid.
std::vector<PlacedPad> place_pads(const BearingDesign& design);

/// Foils of a pad (from 0) as they are given: not stretched.
const BumpFoil& bump_foil_of(const BearingDesign& design, std::size_t pad);

/// Number of pads, one without any.
std::size_t count_pads(const BearingDesign& design);

/// Bumps of all pads.
int total_bumps(const BearingDesign& design);

/// A bump of a pad, both from 0.
struct PadBump {
  std::size_t pad{};
  int bump{};
};

/// Pad and bump of a number counted through all pads, from 0.
PadBump find_bump(const BearingDesign& design, int bump);

}  // namespace bumpfoil
