#pragma once

#include <optional>

#include "bumpfoil/model/foil_design.hpp"
#include "bumpfoil/structure/section.hpp"

namespace bumpfoil {

/// Stiffness (N/m) of one isolated bump loaded at its crest, both feet free to slide and to rotate; bending only. Each
/// foot is held inwards by the thrust mu times its load; with mu the coefficient of Coulomb's law this is a bump whose
/// load grows, with minus that one whose load falls:
///
///     K = 2 EI' / (R_b^3 (A - mu B))
///     A = alpha sin^2 - 2 sin (1 - cos) + alpha/2 - sin(2 alpha)/4,   B = sin (sin - alpha cos) - (1 - cos)^2 / 2
///
/// [Walowit1975]
/// @param thrust_ratio mu
/// @return absent where A <= mu B: bumps this steep lock
std::optional<double> sliding_bump_stiffness(const BumpArc& arc, const Section& section, double thrust_ratio);

/// Limit of the same for shallow bumps without thrust, 6 EI' / l0^3 = E' L e^3 / (2 l0^3), N/m [Walowit1975].
double shallow_bump_stiffness(const BumpArc& arc, const Section& section);

/// The same bump without thrust, the rotation of the feet clamped (N/m):
///
///     K = 2 EI' / (R_b^3 (alpha/2 - sin(2 alpha)/4 - (1 - cos)^2 / alpha))
double guided_bump_stiffness(const BumpArc& arc, const Section& section);

/// Scale of the forces in such foils, N: stiffness of bump 1, taken as shallow, times its rise. Round-off of forces is
/// checked by it where nothing is loaded.
double bump_force_scale(const FoilDesign& foils);

}  // namespace bumpfoil
