#include "experiments/cycle/result_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/path/path.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"

namespace bumpfoil {
namespace {

std::vector<double> to_vector(const Vector& numbers) {
  return {numbers.begin(), numbers.end()};
}

void append(const std::vector<double>& more, std::vector<double>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Common part of both layouts. @param foils  one after the other
ResultLayout layout_of_foils(double axial_length, const std::vector<BumpFoil>& foils) {
  std::vector<BumpShape> shapes;
  std::vector<double> errors, sleeve_gaps, offsets;
  for (const BumpFoil& foil : foils) {
    const std::vector<BumpShape> own = nominal_bumps(foil);
    shapes.insert(shapes.end(), own.begin(), own.end());
    const auto append_one_per_bump = [&own](std::vector<double> numbers, std::vector<double>& all) {
      numbers.resize(own.size());
      append(numbers, all);
    };
    append_one_per_bump(foil.height_errors, errors);
    append_one_per_bump(foil.sleeve_gaps, sleeve_gaps);
    append(to_vector(crest_offsets(foil)), offsets);
  }
  const std::size_t bumps = shapes.size();
  ResultLayout layout;
  layout.bumps = bumps;
  layout.scalars = {
      {"axial_length", "m", "axial length of the foils", {axial_length}},
  };
  layout.at_bumps = {
      {"height_error", "m", "height of the bump over the nominal one", errors},
      {"sleeve_gap", "m", "gap between the feet of the bump and the sleeve before assembly", sleeve_gaps},
  };
  // A single number if bumps are equal.
  const auto add = [&](std::string name, std::string long_name, double BumpShape::*member) {
    std::vector<double> values;
    values.reserve(bumps);
    for (const BumpShape& shape : shapes) values.push_back(shape.*member);
    const bool alike = std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
    if (alike) values.resize(1);
    (alike ? layout.scalars : layout.at_bumps)
        .push_back({std::move(name), "m", std::move(long_name), std::move(values)});
  };
  add("bump_pitch", "distance from crest to crest along the foil", &BumpShape::pitch);
  add("bump_half_length", "half the chord of the arc of a bump", &BumpShape::half_length);
  add("bump_rise", "rise of the mid-surface of a nominal bump", &BumpShape::rise);
  add("bump_thickness", "thickness of the bump foil at a bump", &BumpShape::thickness);
  if (offsets != errors) {
    layout.at_bumps.push_back({"crest_offset", "m",
                               "height of the crest over that of the tallest nominal bump before assembly: nominal, "
                               "height error and shim",
                               offsets});
  }
  return layout;
}

/// The strip of a split top foil that each pad represents.
void add_strips_of_pads(const std::vector<PlacedPad>& pads, ResultLayout& layout) {
  NamedNumbers strip{"pad_strip", "1", "strip of the foils that the pad is, from the side z < 0 on", {}};
  NamedNumbers z{"pad_z", "m", "distance of the middle of the strip from the mid-plane of the bearing", {}};
  for (const PlacedPad& pad : pads) {
    strip.values.push_back(pad.strip + 1);
    z.values.push_back(0.5 * pad.middle * pad.alone.bearing.axial_length / pad.part);
  }
  layout.at_pads.insert(layout.at_pads.end(), {std::move(strip), std::move(z)});
}

/// Positions of several pads, and the pad of each bump and foot.
void add_pads(const std::vector<PlacedPad>& pads, ResultLayout& layout) {
  if (pads.size() == 1) return;
  layout.pads = pads.size();
  NamedNumbers weld{"pad_weld_angle", "rad", "polar angle of the weld of the pad from X towards Y", {}};
  NamedNumbers end{"pad_end_angle", "rad", "polar angle of the free end of the pad from X towards Y", {}};
  NamedNumbers lobe{"pad_lobe", "m", "preload: offset of the centre of the pad away from its middle", {}};
  NamedNumbers of_bumps{"bump_pad", "1", "pad that the bump belongs to", {}};
  NamedNumbers of_feet{"foot_pad", "1", "pad that the foot belongs to", {}};
  for (const PlacedPad& pad : pads) {
    weld.values.push_back(pad.alone.bearing.weld_angle);
    end.values.push_back(pad.end());
    lobe.values.push_back(pad.lobe);
    const auto number = static_cast<double>(weld.values.size());
    of_bumps.values.resize(of_bumps.values.size() + static_cast<std::size_t>(pad.alone.bump_foil.bumps), number);
    of_feet.values.resize(of_feet.values.size() + static_cast<std::size_t>(pad.feet.size()), number);
  }
  layout.at_pads = {std::move(weld), std::move(end), std::move(lobe)};
  if (pads.front().strips > 1) add_strips_of_pads(pads, layout);
  layout.at_bumps.push_back(std::move(of_bumps));
  layout.at_feet.push_back(std::move(of_feet));
}

/// Shape of formed top foils without a journal.
void add_assembly(const Case& input, const std::vector<PlacedPad>& pads, ResultLayout& layout) {
  if (std::none_of(pads.begin(), pads.end(), [](const PlacedPad& pad) { return is_formed(pad.alone); })) return;
  const BearingModel foils = pads.front().strips > 1 ? make_film_foils(input) : foils_without_journal(input);
  if (foils.assembly.empty()) return;
  NamedNumbers formed{"formed_radius", "m", "radius that the top foil is formed to before its assembly", {}};
  NamedNumbers hold{"assembled_hold_down", "N", "load of the top foil on its last bump, without a journal", {}};
  NamedNumbers lifted{"assembled_lifted_bumps", "1", "bumps before the last that the top foil does not rest on", {}};
  NamedNumbers bulge{"assembled_bulge", "m", "largest inward displacement of the top foil over a crest", {}};
  NamedNumbers place{"assembled_bulge_theta", "rad", "angle of that crest from the weld along the foil", {}};
  NamedNumbers room{
      "assembled_room", "m", "minimum gap to a centred journal; negative: the foil touches it at rest", {}};
  for (std::size_t k = 0; k < pads.size(); ++k) {
    const PadDesign& alone = pads[k].alone;
    const PadAssembly& assembly = foils.assembly[k];
    formed.values.push_back(formed_radius(alone.top_foil.formed_radius, alone.bearing));
    hold.values.push_back(assembly.hold_down);
    lifted.values.push_back(assembly.lifted);
    bulge.values.push_back(assembly.bulge);
    place.values.push_back(assembly.bulge_theta);
    room.values.push_back(foils.assembled_clearance_in(k));
  }
  std::vector<NamedNumbers>& list = pads.size() == 1 ? layout.scalars : layout.at_pads;
  list.insert(list.end(), {formed, hold, lifted, bulge, place, room});
}

ResultLayout layout_of_bearing(const Case& input, const std::vector<PlacedPad>& pads) {
  std::vector<BumpFoil> foils;
  foils.reserve(pads.size());
  std::vector<double> theta, phi, foot_theta, foot_phi;
  for (const PlacedPad& pad : pads) {
    foils.push_back(pad.alone.bump_foil);
    append(to_vector(pad.crests), theta);
    append(to_vector(pad.polar(pad.crests)), phi);
    append(to_vector(pad.feet), foot_theta);
    append(to_vector(pad.polar(pad.feet)), foot_phi);
  }
  ResultLayout layout = layout_of_foils(input.bearing.axial_length, foils);
  layout.feet = foot_theta.size();
  layout.scalars.insert(
      layout.scalars.end(),
      {{"bearing_radius", "m", "radius R of the circle on which the foils lie", {input.bearing.radius}},
       {"radial_clearance", "m", "radial clearance; negative means interference", {input.bearing.radial_clearance}}});
  if (input.width.profile() != WidthProfile{}) {
    layout.scalars.insert(
        layout.scalars.end(),
        {{"conicity", "m", "clearance at the side z > 0 less that at z < 0", {input.width.conicity}},
         {"crowning", "m", "clearance at both sides less that in the middle", {input.width.crowning}}});
  }
  layout.at_bumps.insert(layout.at_bumps.end(),
                         {{"theta", "rad", "angle of the crest from the weld along the foil", theta},
                          {"phi", "rad", "polar angle of the crest from X towards Y", phi}});
  layout.at_feet = {{"foot_theta", "rad", "angle of the foot from the weld along the foil", foot_theta},
                    {"foot_phi", "rad", "polar angle of the foot from X towards Y", foot_phi}};
  add_pads(pads, layout);
  add_assembly(input, pads, layout);
  layout.bump_coordinates = "theta phi";
  layout.foot_coordinates = "foot_theta foot_phi";
  return layout;
}

ResultLayout layout_of_cycles(const Case& input) {
  const CycleSettings& cycle = input.settings.get<CycleSettings>();
  ResultLayout layout = make_bearing_layout(input);
  layout.cycles = {"direction", "degree", "direction of the push, from X towards Y", {}};
  std::vector<double>& sorted = layout.cycles.values;
  for (const double direction : cycle.directions) sorted.push_back(to_degrees(direction));
  // Sorted so that readers can use nearest-value selection.
  std::sort(sorted.begin(), sorted.end());
  for (const double direction : cycle.directions) {
    const auto found = std::find(sorted.begin(), sorted.end(), to_degrees(direction));
    layout.places.push_back(static_cast<std::size_t>(found - sorted.begin()));
  }
  layout.increments = std::size_t{cycle.is_fully_reversed() ? 4U : 2U} * static_cast<std::size_t>(cycle.steps) + 1;
  return layout;
}

ResultLayout layout_of_path(const Case& input) {
  ResultLayout layout = make_bearing_layout(input);
  layout.places = {0};
  layout.increments = static_cast<std::size_t>(path_increments(input.settings.get<PathSettings>()));
  return layout;
}

ResultLayout layout_of_strip(const Case& input) {
  const StripSettings& strip = input.settings.get<StripSettings>();
  const FoilDesign foils = make_strip_design(input, strip.bumps, strip.weld, strip.top_foil);
  const Vector feet = foot_positions(foils);
  ResultLayout layout = layout_of_foils(input.bearing.axial_length, {cut_to(input, strip.bumps).bump_foil});
  layout.cycles = {"cycle", "1", "cycle of the plate", {}};
  for (int cycle = 1; cycle <= strip.cycles; ++cycle) layout.cycles.values.push_back(cycle);
  layout.places.resize(layout.cycles.values.size());
  std::iota(layout.places.begin(), layout.places.end(), std::size_t{0});
  layout.increments = std::size_t{strip.preload ? 4U : 2U} * static_cast<std::size_t>(strip.steps) + 1;
  layout.feet = static_cast<std::size_t>(feet.size());
  layout.at_bumps.push_back({"crest_position", "m", "position of the crest along the strip, from the weld or the start",
                             to_vector(crest_positions(foils))});
  layout.at_feet = {
      {"foot_position", "m", "position of the foot along the strip, from the weld or the start", to_vector(feet)}};
  layout.bump_coordinates = "crest_position";
  layout.foot_coordinates = "foot_position";
  return layout;
}

}  // namespace

ResultLayout make_result_layout(const Case& input, Experiment experiment) {
  switch (experiment) {
    case Experiment::strip:
      return layout_of_strip(input);
    case Experiment::path:
      return layout_of_path(input);
    case Experiment::cycle:
      break;
  }
  return layout_of_cycles(input);
}

ResultLayout make_bearing_layout(const Case& input) {
  ResultLayout layout = layout_of_bearing(input, place_pads(input));
  layout.strips = strips_apart(input);
  return layout;
}

ResultLayout make_film_layout(const Case& input) {
  ResultLayout layout = layout_of_bearing(input, place_film_pads(input));
  const bool together = input.lets_strips_move_apart() && !input.top_foil.split;
  layout.strips = together ? static_cast<std::size_t>(input.bump_foil.strips) : 1;
  return layout;
}

std::vector<std::string> ResultLayout::dims_of(Node at) const {
  if (at == Node::bump) return {"bump"};
  if (at == Node::foot) return {"foot"};
  if (at == Node::strip) return {"strip"};
  return at == Node::foil || pads == 1 ? std::vector<std::string>{} : std::vector<std::string>{"pad"};
}

std::string ResultLayout::coordinates_of(Node at) const {
  if (at == Node::bump) return bump_coordinates;
  return at == Node::foot ? foot_coordinates : std::string();
}

void add_foils(const ResultLayout& layout, std::string_view carrying, Dataset& data) {
  const auto count = [&data](const char* name, std::string long_name, std::size_t size) {
    data.add_dimension({name, "1", std::move(long_name), {Form::whole}}, numbers_from(1.0, size));
  };
  const bool several = layout.pads > 1;
  count("bump", several ? "bump, counted from the weld, pad after pad" : "bump, counted from the weld", layout.bumps);
  count("foot", fmt::format("foot of the bump foil on the {}, counted from the weld", carrying), layout.feet);
  if (several) count("pad", "pad, in the order of the case", layout.pads);
  if (layout.strips > 1) count("strip", "strip of the bump foil, from the side z < 0 on", layout.strips);
  const auto put = [&data](const std::vector<NamedNumbers>& all, const std::vector<std::string>& dims) {
    for (const NamedNumbers& one : all) data.add_coordinate({one.name, one.unit, one.long_name}, dims, one.values);
  };
  put(layout.scalars, {});
  put(layout.at_bumps, {"bump"});
  put(layout.at_feet, {"foot"});
  put(layout.at_pads, {"pad"});
}

}  // namespace bumpfoil
