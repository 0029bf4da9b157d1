#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/model/bearing_design.hpp"
#include "bumpfoil/model/foil_design.hpp"

namespace bumpfoil {

/// Once round, rad.
inline constexpr double turn = 2.0 * std::numbers::pi;

/// Height h_b of a bump of a foil (from 0) without its height error, m, read as `height_reference` says.
double nominal_height(const BumpFoil& foil, std::size_t bump);

/// A bump of a foil (from 0) without its height error; its rise is height - thickness or height, as `height_reference`
/// says.
BumpShape nominal_bump(const BumpFoil& foil, std::size_t bump = 0);

/// All of them.
std::vector<BumpShape> nominal_bumps(const BumpFoil& foil);

/// How much higher than that of the tallest nominal bump each crest of a foil stands, m, without the top foil: what its
/// bump is taller by nominally (never positive), its height error, and the shim under it. The tallest nominal bumps
/// support the top foil, and the clearance is measured to it there.
Vector crest_offsets(const BumpFoil& foil);

/// w(phi), m.
double deviation_at(const RadiusProfile& profile, double phi);

/// Foils of a pad. Every bump has its nominal shape, and height errors act through the gaps alone,
/// unless `stiffness_follows_height` gives each bump its own rise. The pad must be valid.
FoilDesign make_bearing_design(const PadDesign& pad);

/// Whether the top foil of a pad is formed otherwise than the circle that it lies on.
bool is_formed(const PadDesign& pad);

/// Foils cut to the first of their bumps.
PadDesign cut_to(const PadDesign& whole, int bumps);

/// Foils of a strip: flat, cut to the first of their bumps, with a top foil or without. All must be valid.
FoilDesign make_strip_design(const PadDesign& whole, int bumps, StripWeld weld, bool top_foil);

/// Angles of the crests from the weld along the foil, their places over R, rad: theta_i = (i - 1/2) p / R for equal
/// pitches.
Vector crest_angles(const PadDesign& pad);

/// Angles of the feet from the weld along the foil, in the order of the results, rad.
Vector foot_angles(const PadDesign& pad);

/// R_f of a top foil before its assembly, m.
double formed_radius(const FormedRadius& formed, const Bearing& bearing);

/// Angle of the end of the top foil from the weld, rad: all pitches over R, unless it has an overhang of its own, and
/// by how much the last strip of the bump foil is staggered.
double foil_angle(const PadDesign& pad);

/// Width of each strip of a bump foil, m.
double strip_width(const PadDesign& pad);

/// z in the middle of a strip, m. @param strip  from 0
double strip_middle(const PadDesign& pad, int strip);

/// Radial deviation of the sleeve from nominal at `theta` from the weld along the foil, taper included, m.
Vector sleeve_deviations(const PadDesign& pad, const Vector& theta);

/// Polar angles in the X-Y plane of points at `theta` from the weld, phi = weld_angle -+ theta, rad.
Vector polar_angles(const Bearing& bearing, const Vector& theta);

/// Unit vector at polar angle `direction` (rad). Exact along the axes: zero, not 6e-17.
Eigen::Vector2d unit_vector(double direction);

/// Unit vectors n_i = (cos(phi_i), sin(phi_i)) from the axis of the bearing to points at polar angles `phi` (rad).
Eigen::Matrix2Xd outward_normals(const Vector& phi);

/// Gaps between journal and undeformed top foil, r_i = C_r - n_i . (x, y), m. `clearance` is C_r, `normals` are n_i;
/// the journal centre stands at `position` (x, y). [Arghir2019, Eq. 3] prints the other sign before y, which its own
/// results contradict.
Vector journal_gaps(double clearance, const Eigen::Matrix2Xd& normals, const Eigen::Vector2d& position);

/// Applied force on the journal that balances the loads `journal_loads` (>= 0, N, one per normal) of the top foil: sum
/// of p_i n_i, N.
Eigen::Vector2d journal_force(const Eigen::Matrix2Xd& normals, const Vector& journal_loads);

}  // namespace bumpfoil
