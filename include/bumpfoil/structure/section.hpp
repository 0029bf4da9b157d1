#pragma once

#include "bumpfoil/model/foil_design.hpp"

namespace bumpfoil {

/// Cross-section of a foil bent as a plate: wide against its thickness, so the plane-strain modulus acts.
///
///     E' = E / (1 - nu^2),   EI' = E' L e^3 / 12,   EA' = E' L e,   W = L e^2 / 6
struct Section {
  double bending_stiffness{};  ///< EI', N m^2
  double axial_stiffness{};    ///< EA', N
  double modulus{};            ///< W, m^3: bending stress at the surfaces |M| / W

  bool operator==(const Section&) const = default;
};

/// @param youngs_modulus E, Pa
/// @param poisson_ratio nu
/// @param axial_length L, m
/// @param thickness e, m
Section make_section(double youngs_modulus, double poisson_ratio, double axial_length, double thickness);

/// Section of the bump foil along one of its bumps.
Section make_bump_section(const FoilDesign& foils, const BumpShape& bump);

/// Section of the top foil. There must be one.
Section make_top_foil_section(const FoilDesign& foils);

}  // namespace bumpfoil
