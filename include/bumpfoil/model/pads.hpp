#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "bumpfoil/model/bearing_design.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {

/// A single pad, and where its foils lie.
struct PlacedPad {
  PadDesign alone;                   ///< the bearing as if this were all its foils
  double lobe{};                     ///< Pad::lobe, m
  Eigen::Vector2d centre{0.0, 0.0};  ///< of the circle of the pad, m: the bearing's, displaced away from its middle
  double arc{};                      ///< angle from the weld to the free end, rad
  Vector crests, feet;               ///< angles from the weld along the foil, rad
  /// Of the strips that its foils are cut into over the width the one that this is, from 0; `alone` is as wide as it.
  int strip{};
  int strips{1};
  double middle{};   ///< where its middle lies over the width: -1 and 1 at the sides of the bearing
  double part{1.0};  ///< of the width of the bearing that it takes

  /// sigma: +1 where theta runs from X to Y.
  [[nodiscard]] double sense() const { return alone.bearing.wrap == Wrap::clockwise ? -1.0 : 1.0; }
  /// Polar angles of points at angles from the weld, rad.
  [[nodiscard]] Vector polar(const Vector& theta) const { return polar_angles(alone.bearing, theta); }
  /// Polar angle of the free end, rad.
  [[nodiscard]] double end() const { return polar(Vector::Constant(1, arc))[0]; }
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

/// A bump foil all of whose bumps have the dimensions of those of one of its strips.
BumpFoil with_bumps_of(BumpFoil foil, const FoilStrip& strip);

/// A pad all of whose bump foil is as one of its strips: with its height errors and, where it is staggered, its weld.
/// @param strip  from 0
PlacedPad strip_of(const PlacedPad& pad, int strip);

/// A strip of a pad by itself, as wide as the strip, with all of its top foil over it.
/// @param strip  from 0
PlacedPad cut_out(const PlacedPad& pad, int strip);

/// The pads of a bearing under a film. Where the top foil is split over the width every strip of a pad is one by
/// itself, as wide as the strip, with a film from edge to edge: pad after pad, strip after strip from the side z < 0
/// on. Otherwise those of place_pads(). The design must be valid.
std::vector<PlacedPad> place_film_pads(const BearingDesign& design);

/// Foils of a pad (from 0) as they are given: not stretched.
const BumpFoil& bump_foil_of(const BearingDesign& design, std::size_t pad);

/// Number of pads, one without any.
std::size_t count_pads(const BearingDesign& design);

/// Bumps of all pads.
int total_bumps(const BearingDesign& design);

/// Bumps under a film: those of all strips, where place_film_pads() cuts them out.
int film_bumps(const BearingDesign& design);

/// A bump of a pad, both from 0.
struct PadBump {
  std::size_t pad{};
  int bump{};
};

/// Pad and bump of a number counted through all pads, from 0.
PadBump find_bump(const BearingDesign& design, int bump);

}  // namespace bumpfoil
