#pragma once

#include <span>
#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/structure/width_lines.hpp"

namespace bumpfoil {

/// The lines over the width with the indices of their unknowns in a block: those of the first line are the foils' own,
/// those of the others start at `further`. Top foil and crest have unknowns on every line. The rest of the bump foil
/// has them, too, if a mode slides and lifts its feet: the linear mode, and those of higher order if the sheet is
/// flexible.
std::vector<FoilLine> foil_lines_of(const WidthLines& lines, SheetModel sheet, const BumpDofs& dofs, int further);

/// Number of unknowns of a block up to the last one of any line or point.
int unknowns_on_lines(const BearingModel& foils);

/// Number of stress-function unknowns of a sheet, which follow them.
int unknowns_of_sheet(const BearingModel& foils, const WidthLines& width);

/// The largest entry of K of the bump foils alone, N/m.
double stiffest_of_bump_foils(const FoilStructure& structure);

/// Adds the bump foils on these lines to K. Modes that are uniform or linear over the width displace the whole bump
/// foil, and each of its slices responds like the bump foil there. The same holds for modes of higher order if the
/// sheet is flexible, which couples the slices; if not, springs on the crest resist these modes, and nothing slides or
/// lifts.
void add_bump_foils(const BearingModel& foils, const WidthLines& width, BlockTridiagonal& K);

/// Places the contacts of foils that are uniform over the width on the lines and points of other foils, which already
/// have their K: sites and gaps without the journal.
/// @param strips     one set of foils per strip, each uniform over the width; one set without strips
/// @param elsewhere  gaps of blocks that `strips` do not have, m
void put_contacts_on_lines(std::span<const BearingModel> strips, double elsewhere, BearingModel& on_lines);

/// Foils on placed pads, uniform over the width. Their equilibrium without a journal is not computed.
BearingModel make_uniform_foils(std::vector<PlacedPad> pads);

}  // namespace bumpfoil
