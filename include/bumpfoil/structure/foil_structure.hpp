#pragma once

#include <optional>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/model/foil_design.hpp"
#include "bumpfoil/structure/corotational.hpp"
#include "bumpfoil/structure/forming.hpp"

namespace bumpfoil {

/// Place of the unknowns inside the block of a bump. Absent ones are -1.
struct BumpDofs {
  int size{};               ///< unknowns per bump
  int crest_u{-1};          ///< tangential displacement of the crest, positive away from the weld
  int crest_v{-1};          ///< radial displacement of the crest, positive outward
  std::vector<int> foot_u;  ///< of each foot of the bump, in the order met from the weld
  std::vector<int> foot_v;
  int top_u{-1};       ///< radial displacement of the top foil over the crest, positive outward
  int top_moment{-1};  ///< scaled bending moment of the top foil at the crest; not a displacement
  int unused{};        ///< unused places at the end of the block

  [[nodiscard]] int feet() const { return static_cast<int>(foot_u.size()); }
};

/// Unknowns of a bump in each model, see make_foil_structure().
BumpDofs make_bump_dofs(const FoilDesign& foils);

/// Foils with large displacements: the elements of the bump foil are corotational, the rest stays linear.
struct LargeDisplacements {
  std::vector<ElementChain> bump_foils;  ///< of each pad
  BlockTridiagonal rest;                 ///< K of the foils without these elements
};

/// Blocks of a pad in K.
struct PadBlocks {
  int first{};
  int count{};
};

/// Elastic foils without contact: what the contact problem is built from. A plain value.
///
/// K is symmetric block tridiagonal with one block per bump. Displacements and top-foil moments are its unknowns; the
/// rows of the moments are the compatibility of the top foil, with what forming adds to it at their right-hand side:
///
///     [ K_b   0   0 ] [u_b]   [ loads on the bump foil ]
///     [  0    0   D ] [u_t] = [ loads on the top foil  ]          K_t = D T^-1 D'
///     [  0    D' -T ] [ M ]   [ forming_rotations()    ]
///
/// Each moment stands as M p^2 / EI' (m; p = reference_length(), EI' of the top foil), so that all of K is in N/m and
/// its top part is of the order EI' / p^3. The moment at the weld is eliminated into the first block. The moment over
/// the last crest is zero; its place is kept, coupled to nothing, so that all blocks have one size.
///
/// Under large displacements K is the stiffness of the undeformed foils.
struct FoilStructure {
  BlockTridiagonal K;
  BumpDofs dofs;
  int first_bump{};  ///< block of bump 1; a block before it stands for the foot where a truss without a weld begins
  std::vector<int> pads{0};  ///< block that each pad begins with, coupled to none before
  Vector forming;            ///< loads of K x that stand for the forming of top foils, N: what it adds to the rows of
                             ///< moments, and to the others as the moment at the weld is eliminated
  double forming_energy{};   ///< of held moments and displacements with that at the weld, J: see elastic_response()
  std::optional<LargeDisplacements> large_displacements{};

  [[nodiscard]] int bumps() const { return K.blocks() - first_bump; }
  /// @param pad  from 0
  [[nodiscard]] PadBlocks blocks_of(int pad) const;
};

/// The truss or the frame model of the bump foil, and the top foil over it.
///
/// Truss, 6 unknowns per bump: crest u, v; foot (after the crest) u, v; top foil displacement, moment. The Le Lez
/// (2007) model has the first four alone. Frame, 11 unknowns per bump: see frame_dofs().
///
/// Unknowns without meaning (the top foil where there is none, all but the foot of the block before bump 1) are kept,
/// so that all blocks have one size: held by springs that nothing else is coupled to, they stay zero. Foils that are
/// free at both ends are held by springs of `loose_hold` at every foot and, the top foil, at every crest: what nothing
/// else determines stays in place.
/// @throws Error (input) if the constants of the truss cannot be identified.
FoilStructure make_foil_structure(const FoilDesign& foils);

/// Appends the foils of one more pad: of the same model, and welded in the same way.
void append(const FoilStructure& pad, FoilStructure& foils);

/// Block of bump 1, see FoilStructure.
int block_of_bump_1(const FoilDesign& foils);

/// Stiffness of the springs that keep loose foils from drifting, N/m: the force of a micrometre is a hundred millionth
/// of a newton, below every tolerance of contact forces, and still a thousand times the round-off of balanced forces.
inline constexpr double loose_hold = 1e-2;

/// Left-hand side of the balance, N: K x, or under large displacements the forces of the corotational elements and of
/// the linear rest. Rows of moments hold their compatibility.
Vector internal_forces(const FoilStructure& structure, const Vector& x);

/// Derivative of internal_forces, N/m: K, unless displacements are large.
BlockTridiagonal tangent_stiffness(const FoilStructure& structure, const Vector& x);

/// The same with the stable tangents of the elements.
BlockTridiagonal stable_tangent_stiffness(const FoilStructure& structure, const Vector& x);

/// Forces and energy of displaced foils.
struct ElasticResponse {
  Vector forces;    ///< of the bump foil, D M on the top foil, zero in the rows of moments, N
  double energy{};  ///< 1/2 M' T M of the top foil, with T M = D' u - r, r of forming_rotations(), and 1/2 u_b' K_b u_b
                    ///< of the bump foil, or under large displacements the energy of its elements, J
};

/// Elastic forces and energy. The moments in `x` are not used: they are recomputed from the displacements.
ElasticResponse elastic_response(const FoilStructure& structure, const Vector& x);

}  // namespace bumpfoil
