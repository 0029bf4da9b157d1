#pragma once

#include <optional>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// How the corrugated foil is modelled.
enum class BumpFoilModel {
  truss,   ///< springs between crests and feet, four degrees of freedom per bump [Arghir2019]
  frame,   ///< exact circular-arc and straight beam elements
  former,  ///< truss with feet that never lift and no top foil [LeLez2007]
};

/// Whether displacements change the geometry of the bump foil.
enum class Geometry {
  linear,     ///< not at all: small displacements
  nonlinear,  ///< elements move and turn with their ends: large displacements (frame model only)
};

/// Where the bump foil is clamped.
enum class WeldPosition {
  mid_flat,   ///< in the middle of the flat before bump 1
  arc_start,  ///< at the start of the first arc: the weld covers the flat (frame model only)
};

/// Constants of the truss model; those that are absent are identified from a planar frame of the same foil.
struct TrussOverrides {
  std::optional<double> k1;       ///< N/m
  std::optional<double> k2;       ///< N/m
  std::optional<double> k3;       ///< N/m
  std::optional<double> k4;       ///< N/m
  std::optional<double> theta_d;  ///< rad

  bool operator==(const TrussOverrides&) const = default;
};

/// One bump of a foil, its arc in the middle of a pitch: half a flat before it, half a flat after it.
struct BumpShape {
  double pitch{};        ///< p, m
  double half_length{};  ///< half the chord of the arc l0, m
  double rise{};         ///< h of the mid-surface, m
  double thickness{};    ///< e_f, of the arc and of its two half flats, m

  bool operator==(const BumpShape&) const = default;
};

/// Circular arc of a bump, mid-surface, unwrapped onto a straight base.
///
///     R_b = (l0^2 + h^2) / (2 h),   sin(alpha) = l0 / R_b
///
/// `half_angle` exceeds pi/2 where the rise exceeds the half chord.
struct BumpArc {
  double half_length{};  ///< l0, m
  double rise{};         ///< h of the mid-surface, m
  double radius{};       ///< R_b, m
  double half_angle{};   ///< alpha, rad
  double flat{};         ///< length of the two half flats of the bump, p - 2 l0, m
};

BumpArc make_bump_arc(const BumpShape& bump);

/// The sheet of a top foil.
struct TopFoilDesign {
  double thickness{};       ///< m
  double youngs_modulus{};  ///< Pa
  double poisson_ratio{};
  double overhang{};       ///< from the last crest to the free end, m
  double stagger{};        ///< by which the last crest is that of a staggered strip, beyond the last bump, m
  double flattening{};     ///< 1/R - 1/R_f, 1/m: how much flatter it is formed than the circle that it lies on
  double seat_pressure{};  ///< that its forming, beside this, presses on all bumps with, Pa
};

/// A pair of foils on a sleeve or on a flat base: the data that define their elastic structure. Bumps may differ from
/// each other in anything that a BumpShape holds. A plain value.
struct FoilDesign {
  BumpFoilModel model{BumpFoilModel::truss};
  Geometry geometry{Geometry::linear};
  std::vector<BumpShape> bumps;  ///< from the weld on, at least one
  double youngs_modulus{};       ///< E of the bump foil, Pa
  double poisson_ratio{};        ///< nu of the bump foil
  double axial_length{};         ///< width of the top foil, of all its strips together, m
  double strip_gaps{};           ///< part of it that the bump foil leaves free between its strips, m
  std::optional<double> radius;  ///< R of the bearing, m; absent: the foils lie flat
  bool welded{true};             ///< both foils are clamped before bump 1; else they are free at both ends
  WeldPosition weld_at{WeldPosition::mid_flat};
  TrussOverrides truss;  ///< of every bump
  std::optional<TopFoilDesign> top_foil;

  /// Width of the bump foil, of all its strips together, m.
  [[nodiscard]] double bump_foil_width() const { return axial_length - strip_gaps; }
  /// Length by which unknowns that are no displacements are scaled to be lengths, m: the pitch of bump 1.
  [[nodiscard]] double reference_length() const { return bumps.front().pitch; }
};

/// Places of the crests from the weld along the foil, each in the middle of its pitch, m.
Vector crest_positions(const FoilDesign& foils);

/// Places of the feet from the weld along the foil, in the order of the results, m: middle of the flat after each bump
/// in the truss, which without a weld has one more at 0; both ends of each arc in the frame.
Vector foot_positions(const FoilDesign& foils);

}  // namespace bumpfoil
