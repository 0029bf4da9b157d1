#pragma once

#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/model/foil_design.hpp"
#include "bumpfoil/structure/width_lines.hpp"

namespace bumpfoil {

/// Distances of columns along a top foil, from the weld to its free end, in units of `pitch` over columns_per_pitch:
/// half of that number on each half of a pitch, all of one length there, and on the overhang as many as come nearest to
/// the length of those before it, but two. Where the last crest is that of a staggered strip, columns go on to it as on
/// a pitch. There must be a top foil.
/// @param columns_per_pitch  even, so that every crest is a column; times TopFoilDesign::stagger whole pitches of
/// columns
Vector top_foil_intervals(const FoilDesign& foils, int columns_per_pitch, double pitch);

/// A top foil on lines: K x = loads + forming.
struct TopFoilOnLines {
  BlockTridiagonal K;       ///< N/m
  Vector forming;           ///< N: loads by which a foil formed otherwise than it lies presses on what carries it
  double forming_energy{};  ///< of the foil where x is zero, J
};

/// The top foil whose displacement varies over the width, loaded over the crests of the bump foil alone: a beam under
/// each of the lines, as stiff as its part of the width, which the membrane joins (MembraneRows). Symmetric, with one
/// block per bump:
///
///     [ 0   D        w T'          ] [ u ]   [ loads on the top foil ]
///     [ D'  -T/part                ] [ M ] = [ forming_rotations()   ]
///     [ w T         -C             ] [F,m]   [ 0                     ]
///
/// u and M of all lines, M as in FoilStructure; then F of all modes that stretch the foil, in units of EI' over p^4 per
/// metre, and m = A g + nu B F of the same. Columns between the crests, six to a pitch, are eliminated, and so is all
/// between the last crest and the free end. The moment over the last crest is, too: its place is kept, coupled to
/// nothing.
///
/// Staggered strips of the bump foil carry the top foil at several stations of a pitch: some columns, of the six,
/// behind each crest. All unknowns of one station follow those of the one before in the block.
/// @param foils     with a top foil on a circle; at several stations, with equal pitches
/// @param stations  rising, from 0 to 5: the last one is at TopFoilDesign::stagger
TopFoilOnLines top_foil_on_lines(const FoilDesign& foils, const WidthLines& lines,
                                 const std::vector<int>& stations = {0});

}  // namespace bumpfoil
