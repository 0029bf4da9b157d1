#include "bumpfoil/model/pads.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bumpfoil {
namespace {

/// Scales all pitches of a pad's foils, so that the top foil ends at the given arc from the weld.
void stretch(PadDesign& pad, double arc) {
  const double overhang = pad.top_foil.overhang.value_or(0.0) / pad.bearing.radius;  // not scaled
  const double factor = (arc - overhang) / (foil_angle(pad) - overhang);
  BumpFoil& foil = pad.bump_foil;
  for (double& pitch : foil.pitch.values) pitch *= factor;
  for (BumpSection& section : foil.sections) {
    if (section.pitch) *section.pitch *= factor;
  }
}

/// Prescribed arc of the foils of a pad; absent if the foils determine it.
std::optional<double> arc_of(const BearingDesign& design, const Pad& pad) {
  if (pad.arc || !design.bearing.pad_gap) return pad.arc;
  return turn / static_cast<double>(design.pads.size()) - *design.bearing.pad_gap;
}

PlacedPad place_alone(const PadDesign& alone) {
  return {.alone = alone, .arc = foil_angle(alone), .crests = crest_angles(alone), .feet = foot_angles(alone)};
}

PlacedPad place_pad(const BearingDesign& design, std::size_t k) {
  const Pad& pad = design.pads[k];
  PadDesign alone = design;
  alone.bearing.pad_gap.reset();
  if (pad.bump_foil) alone.bump_foil = *pad.bump_foil;
  if (pad.top_foil) alone.top_foil = *pad.top_foil;
  if (const std::optional<double> arc = arc_of(design, pad)) stretch(alone, *arc);

  const double arc = foil_angle(alone);
  const double sense = design.bearing.wrap == Wrap::clockwise ? -1.0 : 1.0;
  const bool trails = pad.weld_edge == WeldEdge::trailing;
  const double share = turn * static_cast<double>(k) / static_cast<double>(design.pads.size());
  const double further = share + (trails ? arc : 0.0);
  if (further > 0.0) alone.bearing.weld_angle = std::remainder(design.bearing.weld_angle + sense * further, turn);
  if (pad.weld_angle) alone.bearing.weld_angle = *pad.weld_angle;
  if (trails) alone.bearing.wrap = design.bearing.wrap == Wrap::clockwise ? Wrap::counterclockwise : Wrap::clockwise;
  PlacedPad placed = place_alone(alone);
  placed.lobe = pad.lobe;
  placed.centre = -pad.lobe * unit_vector(placed.polar(Vector::Constant(1, 0.5 * arc))[0]);
  return placed;
}

}  // namespace

std::vector<PlacedPad> place_pads(const BearingDesign& design) {
  if (design.pads.empty()) return {place_alone(design)};
  std::vector<PlacedPad> pads;
  pads.reserve(design.pads.size());
  for (std::size_t k = 0; k < design.pads.size(); ++k) pads.push_back(place_pad(design, k));
  return pads;
}

BumpFoil with_bumps_of(BumpFoil foil, const FoilStrip& strip) {
  if (strip.thickness) foil.thickness = *strip.thickness;
  if (!strip.sections.empty()) foil.sections = strip.sections;
  return foil;
}

PlacedPad strip_of(const PlacedPad& pad, int strip) {
  PlacedPad placed = pad;
  BumpFoil& foil = placed.alone.bump_foil;
  if (foil.strip.empty()) return placed;
  const FoilStrip own = foil.strip[static_cast<std::size_t>(strip)];
  foil = with_bumps_of(foil, own);
  const auto bumps = static_cast<std::size_t>(foil.bumps);
  foil.height_errors.resize(bumps);
  for (std::size_t n = 0; n < bumps; ++n) foil.height_errors[n] += own.height_errors.at(n, bumps);
  const double along = own.sixths() * (nominal_bump(foil, 0).pitch / staggers_per_pitch);
  placed.alone.bearing.weld_angle += placed.sense() * along / placed.alone.bearing.radius;
  return placed;
}

PlacedPad cut_out(const PlacedPad& pad, int strip) {
  PlacedPad one = strip_of(pad, strip);
  one.strip = strip;
  one.strips = pad.alone.bump_foil.strips;
  one.middle = strip_middle(pad.alone, strip) / (0.5 * pad.alone.bearing.axial_length);
  one.part = strip_width(pad.alone) / pad.alone.bearing.axial_length;
  one.alone.bearing.axial_length = strip_width(pad.alone);
  one.alone.bump_foil.strips = 1;
  one.alone.bump_foil.strip_gap = 0.0;
  one.alone.bump_foil.strip.clear();
  one.alone.top_foil.split = false;
  return one;
}

std::vector<PlacedPad> place_film_pads(const BearingDesign& design) {
  std::vector<PlacedPad> strips;
  for (PlacedPad& pad : place_pads(design)) {
    if (!pad.alone.top_foil.split) {
      strips.push_back(std::move(pad));
      continue;
    }
    for (int strip = 0; strip < pad.alone.bump_foil.strips; ++strip) strips.push_back(cut_out(pad, strip));
  }
  return strips;
}

const BumpFoil& bump_foil_of(const BearingDesign& design, std::size_t pad) {
  const bool own = pad < design.pads.size() && design.pads[pad].bump_foil;
  return own ? *design.pads[pad].bump_foil : design.bump_foil;
}

std::size_t count_pads(const BearingDesign& design) {
  return std::max<std::size_t>(design.pads.size(), 1);
}

int total_bumps(const BearingDesign& design) {
  int bumps = 0;
  for (std::size_t k = 0; k < count_pads(design); ++k) bumps += bump_foil_of(design, k).bumps;
  return bumps;
}

int film_bumps(const BearingDesign& design) {
  return total_bumps(design) * (design.top_foil.split ? design.bump_foil.strips : 1);
}

PadBump find_bump(const BearingDesign& design, int bump) {
  PadBump found{.pad = 0, .bump = bump};
  while (found.pad + 1 < count_pads(design) && found.bump >= bump_foil_of(design, found.pad).bumps) {
    found.bump -= bump_foil_of(design, found.pad).bumps;
    ++found.pad;
  }
  return found;
}

}  // namespace bumpfoil
