#pragma once

#include <Eigen/Core>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

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
  double flat{};         ///< length of the flat between two bumps, p - 2 l0, m
};

/// Arc of the nominal bump; the rise is height - thickness or height, as `height_reference` says.
BumpArc make_bump_arc(const BumpFoil& foil);

/// Places of the crests from the weld along the foil, (i - 1/2) p for i = 1..N, m.
Vector crest_positions(const BumpFoil& foil);

/// Places of the feet from the weld along the foil, in the order of the results, m: middle of the flat after each bump
/// in the truss, which without a weld has one more at 0; both ends of each arc in the frame.
Vector foot_positions(const BumpFoil& foil, bool welded = true);

/// Angles of the crests from the weld along the foil, theta_i = (i - 1/2) p / R for i = 1..N, rad.
Vector crest_angles(const Case& input);

/// Angles of the feet from the weld along the foil, in the order of the results, rad.
Vector foot_angles(const Case& input);

/// Polar angles in the X-Y plane of points at `theta` from the weld, phi = weld_angle -+ theta, rad.
Vector polar_angles(const Bearing& bearing, const Vector& theta);

/// Unit vector at polar angle `direction` (rad). Exact along the axes: no 6e-17 where zero is meant.
Eigen::Vector2d unit_vector(double direction);

/// Unit vectors n_i = (cos(phi_i), sin(phi_i)) from the axis of the bearing to points at polar angles `phi` (rad).
Eigen::Matrix2Xd outward_normals(const Vector& phi);

/// Gaps between journal and undeformed top foil, r_i = C_r - n_i . (x, y), m. `clearance` is C_r, `normals` are n_i;
/// the journal centre stands at `position` (x, y). [Arghir2019, Eq. 3] prints the other sign before y, which its own
/// results contradict.
Vector journal_gaps(double clearance, const Eigen::Matrix2Xd& normals, const Eigen::Vector2d& position);

/// Force that must be applied to the journal to hold it against the loads `journal_loads` (>= 0, N, one per normal) of
/// the top foil: sum of p_i n_i, N.
Eigen::Vector2d journal_force(const Eigen::Matrix2Xd& normals, const Vector& journal_loads);

}  // namespace bumpfoil
