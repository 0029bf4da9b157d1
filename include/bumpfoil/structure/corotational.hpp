#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/structure/frame_element.hpp"

namespace bumpfoil {

/// Displacements and rotations of the ends of an element less the rigid motion of its chord: the start stays in place,
/// the end moves along the undeformed chord, and both turn. With the chord c_0 undeformed and c displaced,
///
///     stretch = |c| - |c_0|,   rotation = rotation of the end node - angle from c_0 to c
///
/// in the order of frame_element_stiffness, m and rad [Crisfield1991, Ch. 7]. Zero for any rigid motion that turns
/// by less than half a turn.
/// @param chord  undeformed, end minus start, m
ElementVector chord_deformations(const Eigen::Vector2d& chord, const ElementVector& displacements);

/// A corotational element: its undeformed chord and the stiffness of its deformation relative to it.
struct CorotationalElement {
  Eigen::Vector2d chord{0.0, 0.0};                     ///< end minus start, m
  Eigen::Matrix3d stiffness{Eigen::Matrix3d::Zero()};  ///< of stretch and rotations of start and end, N/m, N, N m
};

/// @param stiffness  of the undeformed element, order of frame_element_stiffness
CorotationalElement make_corotational_element(const Eigen::Vector2d& chord, const ElementMatrix& stiffness);

/// Energy, forces and tangents of a corotational element under displacements of its ends.
struct CorotationalResponse {
  double energy{};        ///< J
  ElementVector forces;   ///< its gradient, N and N m
  ElementMatrix tangent;  ///< its second derivative, symmetric; at rest frame_element_stiffness
  /// The tangent without the softening by compression and bending, positive semidefinite: D'KD + max(P, 0) s dphi
  /// dphi'.
  ElementMatrix stable_tangent;
};

/// Large displacements, small deformations: 1/2 d'Kd with the deformations d of chord_deformations and the exact
/// stiffness K of frame_element_stiffness. With s = |c| the length of the chord, phi its angle and the stretching force
/// P and end moments M_1, M_2 of K d,
///
///     forces = P ds + M_1 (d theta_1 - d phi) + M_2 (d theta_2 - d phi)
///     tangent = D'KD + P s dphi dphi' + (M_1 + M_2) / s (ds dphi' + dphi ds')
///
/// where D is the derivative of d. Valid while an element bends little by itself: rotations against its chord and
/// stretch over length well below 1.
CorotationalResponse corotational_response(const CorotationalElement& element, const ElementVector& displacements);

/// An element between two nodes, each with three unknowns in a row of a block-tridiagonal system: u, v and rotation.
struct PlacedElement {
  CorotationalElement element;
  Eigen::Index start{-1};  ///< first unknown of the node at its start; -1 is clamped
  Eigen::Index end{};      ///< first unknown of the node at its end
};

/// Elements of a foil, from the weld on. A plain value.
struct ElementChain {
  double rotation_scale{};  ///< rotations (rad) stand among the unknowns as rotation * rotation_scale (m)
  std::vector<PlacedElement> elements;
};

/// Displacements of the ends of an element, m and rad.
ElementVector end_displacements(const ElementChain& chain, const PlacedElement& placed, const Vector& x);

/// Adds the elastic forces of the chain, the gradient of its energy, N. @return its elastic energy, J
double add_corotational_forces(const ElementChain& chain, const Vector& x, Vector& forces);

/// Adds the tangent stiffness of the chain, the derivative of its forces, N/m.
void add_corotational_tangent(const ElementChain& chain, const Vector& x, BlockTridiagonal& K);

/// Adds the stable tangents of the elements, N/m.
void add_stable_tangent(const ElementChain& chain, const Vector& x, BlockTridiagonal& K);

}  // namespace bumpfoil
