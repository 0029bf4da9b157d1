#pragma once

#include <cstdint>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/structure/foil_structure.hpp"

namespace bumpfoil {

/// Model of a bump foil in one piece for displacements that vary over the width by P_k, k >= 2. With them its lines of
/// crests and feet slide by different amounts at different places, and its sheet is sheared and stretched.
enum class SheetModel : std::uint8_t {
  held,     ///< rigid: no line slides and no foot lifts, held_crest_stiffness()
  elastic,  ///< it gives way: every slice moves as the bump foil does, and bump_sheet_stiffness() joins them
};

/// Where stress functions of the sheet are unknown in the block of a bump: at feet and crest.
inline int sheet_nodes(const BumpDofs& dofs) {
  return dofs.feet() + 1;
}

/// The sheet of a bump foil between its slices, which themselves deform along the base. The forces per length in its
/// middle surface are those of a Membrane, with f at the nodes of the truss or frame: weld, ends of arcs and crests, or
/// crests and feet; linear in between and zero at the free end. With the pieces between nodes X long along the base and
/// S along the foil, t thick, and u the mean tangential displacement of each, mode by mode,
///
///     sum G (f_n+1 - f_n) u - U*   is stationary,   f' = (f_n+1 - f_n) / X,
///     U* = 1/2E [ sum_nodes (s/t) g'A g + sum_pieces (S/t) 2 (1 + nu) f'B f' ],   g = (f'_after - f'_before) / s
///
/// where s is half of both S at a node, and the weld has no g. Symmetric, in N/m, with a block for each bump: the
/// unknowns of BumpDofs of each mode, one mode behind the other; then G f / sigma (m), sigma = E t of the first bump,
/// of all modes at each of sheet_nodes(): the end of the bump before or the weld first, the crest last.
/// @param orders  k >= 2 of each mode
BlockTridiagonal bump_sheet_stiffness(const FoilDesign& foils, const std::vector<int>& orders);

}  // namespace bumpfoil
