#pragma once

namespace bumpfoil {

/// Cross-section of a foil bent as a plate: wide against its thickness, so the plane-strain modulus acts.
///
///     E' = E / (1 - nu^2),   EI' = E' L e^3 / 12,   EA' = E' L e,   W = L e^2 / 6
struct Section {
  double bending_stiffness{};  ///< EI', N m^2
  double axial_stiffness{};    ///< EA', N
  double modulus{};            ///< W, m^3: bending stress at the surfaces |M| / W
};

/// @param youngs_modulus E, Pa
/// @param poisson_ratio nu
/// @param axial_length L, m
/// @param thickness e, m
Section make_section(double youngs_modulus, double poisson_ratio, double axial_length, double thickness);

}  // namespace bumpfoil
