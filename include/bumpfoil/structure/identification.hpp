#pragma once

#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/foil_design.hpp"
#include "bumpfoil/structure/section.hpp"
#include "bumpfoil/structure/truss.hpp"

namespace bumpfoil {

/// Energy of one bump of a uniform, symmetrically deformed foil whose arc ends rest on the sleeve, free to slide and to
/// rotate, while the flats may lift; per displacement v of the crest (outward) and growth e of the pitch:
///
///     U = a v^2 / 2 - b v e + d e^2 / 2
struct BumpCell {
  double a{};  ///< N/m
  double b{};  ///< N/m
  double d{};  ///< N/m

  /// Stiffness of the crest when the pitch adapts itself, a - b^2 / d, N/m.
  [[nodiscard]] double crest_stiffness() const { return a - b * b / d; }
};

/// Cell of the plane frame of exact circular arcs and straight flats with plate bending and stretching.
BumpCell make_bump_cell(const BumpArc& arc, const Section& section);

/// Constants that make the truss as stiff as the plane frame of the same foil. The sources print none; these are ours:
///
/// * k1, theta_d and k2 + k3 make the truss exact for the cell: tan(theta_d) = a / (2 b), k1 = a / (2 sin^2(theta_d)),
///   k2 + k3 = d - k1 cos^2(theta_d) / 2;
/// * k3 is what couples u of neighbouring crests in a long strip that is condensed to u, v of the crests and of the
///   middles of the flats, all else free;
/// * k4 gives the first bump, its foot sliding on the sleeve, the stiffness that its frame has between the weld at
///   mid-flat and the next mid-flat (slope zero, free to lift), the arc ends sliding on the sleeve.
///
/// k2 and k4 come out negative for some shapes far from common bumps, which a truss cannot follow: see
/// make_truss_constants.
TrussConstants identify_truss_constants(const BumpArc& arc, const Section& section);

/// Reasons why foils cannot be built as a truss: identified constants that are negative, so that the truss would be
/// unstable. Empty if the truss can be built.
std::vector<InputError> find_truss_errors(const FoilDesign& foils);

/// Constants of the truss, one set per bump: the given ones, and in place of those that are not given the identified
/// ones. A bump's own shape gives its k1, k4 and theta_d, and the sum k2 + k3 of its cell. k3 between two bumps is the
/// mean of theirs, and k2 what the mean of the k3 on both sides leaves of that sum:
///
///     k3_n = (K3_(n-1) + K3_n) / 2,   k2_n = K2_n - (K3_(n-1) - 2 K3_n + K3_(n+1)) / 4
///
/// with K2, K3 of a uniform row of the shape of bump n. A neighbour that is not there counts as one of the same shape.
/// @throws Error (input) listing find_truss_errors(foils) if there are any.
std::vector<TrussConstants> make_truss_constants(const FoilDesign& foils);

}  // namespace bumpfoil
