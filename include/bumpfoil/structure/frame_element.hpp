#pragma once

#include <Eigen/Core>

#include "bumpfoil/model/foil_design.hpp"
#include "bumpfoil/structure/section.hpp"

namespace bumpfoil {

/// A straight or circular-arc beam between two nodes of a plane frame: x away from the weld, y outward, rotations
/// positive from x to y. Valid below a full circle.
struct FrameElement {
  Eigen::Vector2d chord{0.0, 0.0};  ///< end minus start, m
  double turning{};                 ///< angle by which the tangent turns from start to end, rad; 0 is straight

  [[nodiscard]] double length() const;  ///< along the beam, m
};

/// Half of a bump from its start on the sleeve to its crest.
FrameElement rising_half(const BumpArc& arc);
/// Half of a bump from its crest to its end on the sleeve.
FrameElement falling_half(const BumpArc& arc);
/// Straight piece along x.
FrameElement flat_element(double length);

using ElementMatrix = Eigen::Matrix<double, 6, 6>;
using ElementVector = Eigen::Matrix<double, 6, 1>;

/// Exact stiffness for loads at the ends, order u, v, rotation of the start, then of the end (N/m, N, N m):
/// Euler-Bernoulli bending with EI' and stretching with EA'. By Castigliano's theorem the flexibility of forces and
/// moment that act at the elastic centre (the centroid of the beam) is diagonal in the axes of the chord,
///
///     f_t = int eta^2 ds / EI' + int cos^2 ds / EA',   f_n = int xi^2 ds / EI' + int sin^2 ds / EA',   f_m = l / EI'
///
/// and equilibrium carries its inverse to the ends. The integrals are evaluated to full precision for shallow arcs.
ElementMatrix frame_element_stiffness(const Section& section, const FrameElement& element);

/// Stiffness of two elements one after the other, the node between them free of load: order as above, of the start of
/// the first and the end of the second.
ElementMatrix stiffness_in_series(const ElementMatrix& first, const ElementMatrix& second);

/// Action of the part after a cut on the part before it, carried to the elastic centre; the same for every cut.
struct ElementForces {
  double along{};   ///< force along the chord, N
  double across{};  ///< force along the chord turned by +90 deg, N
  double moment{};  ///< N m
};

/// @param displacements of start and end, order of frame_element_stiffness, m and rad
ElementForces element_forces(const Section& section, const FrameElement& element, const ElementVector& displacements);

/// Bending moment (N m) at the fraction `s` of the length from the middle: -1/2 is the start, +1/2 the end.
double bending_moment(const FrameElement& element, const ElementForces& forces, double s);

/// Largest |bending moment| along the element, N m.
double largest_moment(const FrameElement& element, const ElementForces& forces);

}  // namespace bumpfoil
