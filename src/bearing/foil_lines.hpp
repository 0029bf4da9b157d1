#pragma once

#include <span>
#include <vector>

#include "bumpfoil/bearing/foils.hpp"
#include "bumpfoil/structure/width_lines.hpp"

namespace bumpfoil {

/// The lines over the width with the places of their unknowns in a block: of the first in the places of the foils'
/// unknowns, of the others from `further` on. Top foil and crest have unknowns of their own on every line; the rest of
/// the bump foil where a mode slides and lifts its feet, too: one that is linear over the width, and those of a higher
/// order if the sheet gives way.
std::vector<FoilLine> foil_lines_of(const WidthLines& lines, SheetModel sheet, const BumpDofs& dofs, int further);

/// Places of a block up to the last one of any line or point.
int unknowns_on_lines(const Foils& foils);

/// Those of the stress functions of a sheet, which stand behind.
int unknowns_of_sheet(const Foils& foils, const WidthLines& width);

/// The largest entry of K of the bump foils alone, N/m.
double stiffest_of_bump_foils(const FoilStructure& structure);

/// Adds the bump foils on these lines to K. Modes that are uniform or linear over the width displace all of a bump
/// foil, and each of its slices is the bump foil there. So do modes of a higher order if the sheet gives way, which
/// joins the slices; if not, the crest has springs against them, and nothing slides or lifts.
void add_bump_foils(const Foils& foils, const WidthLines& width, BlockTridiagonal& K);

/// The contacts of foils that are uniform over the width on the lines and points of others, which have their K already:
/// sites and gaps without the journal.
/// @param strips     foils that are as each strip all over the width; one if there is none
/// @param elsewhere  gaps of blocks that `strips` have none of, m
void put_contacts_on_lines(std::span<const Foils> strips, double elsewhere, Foils& on_lines);

/// Foils on pads that are worked out already, uniform over the width. How they lie without a journal is not looked for.
Foils make_uniform_foils(std::vector<PlacedPad> pads);

}  // namespace bumpfoil
