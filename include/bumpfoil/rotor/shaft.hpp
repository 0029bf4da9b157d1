#pragma once

#include <Eigen/Core>
#include <vector>

#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// A piece of a shaft of constant circular cross-section.
struct ShaftSection {
  double length{};          ///< m
  double outer_diameter{};  ///< m
  double inner_diameter{};  ///< m; 0: solid
  double youngs_modulus{};  ///< E, Pa
  double poisson_ratio{};
  double density{};  ///< kg/m^3

  bool operator==(const ShaftSection&) const = default;
};

/// A rigid disc on a shaft.
struct ShaftDisc {
  double z{};                   ///< of its centre of mass, m
  double mass{};                ///< kg
  double transverse_inertia{};  ///< about a diameter through its centre of mass, kg m^2
  double polar_inertia{};       ///< about the axis, kg m^2

  bool operator==(const ShaftDisc&) const = default;
};

/// A disc of constant thickness with a hole.
ShaftDisc solid_disc(double z, double thickness, double outer_diameter, double inner_diameter, double density);

/// A flexible shaft with discs. Places are measured from the start of its first section.
struct ShaftDesign {
  std::vector<ShaftSection> sections;
  std::vector<ShaftDisc> discs{};
  std::vector<double> bearings{};  ///< z, m
  std::vector<double> planes{};    ///< z of unbalances, m
  double longest_element{};        ///< of the beams, m
};

/// Part of the cross-section that carries shear, of a circular one with a hole [Cowper1966].
double shear_coefficient(const ShaftSection& section);

/// Beam by Timoshenko's theory in the plane x, z, with shape functions that are exact for loads at its ends
/// [Friswell2010]. Its unknowns are displacement (m) and rotation of the cross-section (dx/dz less shear) at both ends.
struct ShaftElement {
  Eigen::Matrix4d mass;                ///< of translation
  Eigen::Matrix4d transverse_inertia;  ///< of the rotation of cross-sections
  Eigen::Matrix4d stiffness;
};
ShaftElement shaft_element(const ShaftSection& section, double length);

/// Rotary inertia, shear, and gyroscopic terms of shaft and discs. The unknowns of a node are x, y and the rotations of
/// the cross-section in the planes x, z and y, z, positive as dx/dz and dy/dz. Nodes are at ends of sections, discs,
/// bearings and planes, and between them. The stations of the rotor are its ends, the discs and the planes.
/// @pre discs, bearings and planes lie on the shaft
Rotor make_flexible_rotor(const ShaftDesign& design);

}  // namespace bumpfoil
