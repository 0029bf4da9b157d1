#pragma once

#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Place of the unknowns inside the block of a bump. Absent ones are -1.
struct BumpDofs {
  int size{};               ///< unknowns per bump
  int crest_u{-1};          ///< tangential displacement of the crest, positive away from the weld
  int crest_v{-1};          ///< radial displacement of the crest, positive outward
  std::vector<int> foot_u;  ///< of each foot of the bump, in the order met from the weld
  std::vector<int> foot_v;
  int top_u{-1};       ///< radial displacement of the top foil over the crest, positive outward
  int top_moment{-1};  ///< bending moment of the top foil at the crest, N m; not a displacement

  [[nodiscard]] int feet() const { return static_cast<int>(foot_u.size()); }
};

/// Elastic foils without contact: what the contact problem is built from. A plain value.
///
/// K is symmetric block tridiagonal with one block per bump. Displacements (m) and top-foil moments (N m) are its
/// unknowns; the rows of the moments are the compatibility of the top foil, and always have a zero right-hand side:
///
///     [ K_b   0   0 ] [u_b]   [ loads on the bump foil ]
///     [  0    0   D ] [u_t] = [ loads on the top foil  ]          K_t = D T^-1 D'
///     [  0    D' -T ] [ M ]   [           0            ]
struct FoilStructure {
  BlockTridiagonal K;
  BumpDofs dofs;

  [[nodiscard]] int bumps() const { return K.blocks(); }
};

/// Foils of a bearing: the truss or the frame model of the bump foil, as the case says, and the top foil over it.
/// @throws Error (input) if the case cannot be built.
FoilStructure make_foil_structure(const Case& input);

/// Elastic forces of the foils, N: K_b u_b on the bump foil, K_t u_t on the top foil, zero in the rows of moments. The
/// moments in `x` are not used: they are recomputed from the displacements.
Vector elastic_forces(const FoilStructure& structure, const Vector& x);

/// Elastic energy 1/2 u_b' K_b u_b + 1/2 u_t' K_t u_t, J. The moments in `x` are not used.
double elastic_energy(const FoilStructure& structure, const Vector& x);

}  // namespace bumpfoil
