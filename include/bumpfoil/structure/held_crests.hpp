#pragma once

#include "bumpfoil/structure/foil_structure.hpp"

namespace bumpfoil {

/// Stiffness of the crests of a pad (N/m) where no line of crests or feet slides and no foot lifts: the stiffness of
/// the bump foil against displacements that vary over the width by P_k, k >= 2, per unit of the integral of P_k^2 over
/// it. It cannot slide by different amounts at different places: that would stretch and shear it as a sheet. The truss
/// has a spring under each crest; rotations of the frame join neighbours.
/// @param pad  from 0
Matrix held_crest_stiffness(const FoilStructure& structure, int pad);

}  // namespace bumpfoil
