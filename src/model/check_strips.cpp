#include "model/check_strips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/model/pads.hpp"

namespace bumpfoil {
namespace {

constexpr int most_strips = 20;
/// Minimum total width of the strips, relative to the bearing: less indicates a wrong unit.
constexpr double least_width = 0.05;
/// Accepts 0.33 for a third of a pitch.
constexpr double stagger_tolerance = 0.02;

/// Checks the number of strips and the gaps between them. @return whether they are usable
bool check_gaps(Checks& checks, const PadDesign& pad) {
  const BumpFoil& foil = pad.bump_foil;
  if (!checks.count("bump_foil.strips", foil.strips, "strips", {1, most_strips})) return false;
  if (!checks.within("bump_foil.strip_gap", foil.strip_gap, {0.0, length_range.most, "m"})) return false;
  if (!checks.require(foil.is_split() || foil.strip_gap == 0.0, "bump_foil.strip_gap", quantity(foil.strip_gap, "m"),
                      "applies between strips, and there is only one", "set bump_foil.strips, or remove it")) {
    return false;
  }
  const double length = pad.bearing.axial_length;
  const double most = foil.is_split() ? (1.0 - least_width) * length / (foil.strips - 1) : 0.0;
  return checks.require(!foil.is_split() || !(length > 0.0) || foil.strip_gap <= most, "bump_foil.strip_gap",
                        quantity(foil.strip_gap, "m"),
                        fmt::format("leaves no width for {} strips on {:.6g} m", foil.strips, length),
                        fmt::format("give {:.6g} m at most", most));
}

void check_heights(Checks& checks, const std::string& key, const PerBump& heights, int bumps, double rise) {
  const bool as_many = !heights.is_list() || bumps < 1 || std::cmp_equal(heights.values.size(), bumps);
  checks.require(as_many, key, fmt::format("{} values", heights.values.size()),
                 fmt::format("there must be one value per bump, {} in all", bumps),
                 "give one for all bumps, or all of them");
  const auto largest = std::max_element(heights.values.begin(), heights.values.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  if (largest == heights.values.end() || !checks.finite(key, *largest, "m") || rise <= 0.0) return;
  checks.require(std::abs(*largest) < rise, key, quantity(*largest, "m"),
                 fmt::format("is more than the rise of the bump, {:.6g} m", rise), "is the unit right?");
}

/// @return whether the stagger is valid
bool check_stagger(Checks& checks, const std::string& key, double stagger) {
  if (!checks.finite(key, stagger, "")) return false;
  const double sixths = staggers_per_pitch * stagger;
  const double nearest = std::round(sixths);
  const bool right = nearest >= 0.0 && nearest < staggers_per_pitch &&
                     std::abs(sixths - nearest) <= staggers_per_pitch * stagger_tolerance;
  return checks.require(right, key, quantity(stagger, ""), "is not a multiple of a sixth of a pitch, below one pitch",
                        "give 0, 0.17, 0.33, 0.5, 0.67 or 0.83");
}

/// Checks thickness and sections of a strip, and the resulting bump shapes.
/// @param key  of the strip, with a trailing dot
void check_own_bumps(Checks& checks, const std::string& key, const BumpFoil& foil, const FoilStrip& strip,
                     double radius) {
  const std::string sections = key + "section";
  const std::string tables = fmt::format("{} tables", strip.sections.size());
  if (!checks.require(strip.sections.empty() || foil.sections.empty(), sections, tables,
                      "conflicts with bump_foil.section, which applies to all strips",
                      "give sections of the bump foil or of its strips") ||
      (strip.thickness && !checks.within(key + "thickness", *strip.thickness, length_range))) {
    return;
  }
  for (std::size_t i = 0; i < strip.sections.size(); ++i) {
    const BumpSection& section = strip.sections[i];
    checks.require(!section.pitch && !section.height, fmt::format("{}[{}]", sections, i + 1), "",
                   "gives a strip pitches or heights, which are common to all strips",
                   "give height_errors of the strip, or the pitch of bump_foil");
  }
  const std::string own = strip.thickness ? key + "thickness" : sections;
  const std::string value = strip.thickness ? quantity(*strip.thickness, "m") : tables;
  const bool thicker = strip.thickness || std::any_of(strip.sections.begin(), strip.sections.end(),
                                                      [](const BumpSection& one) { return one.thickness.has_value(); });
  checks.require(!thicker || foil.height_reference == HeightReference::overall, own, value,
                 "would change the height of the bumps, which is given for the mid-surface",
                 "give overall heights, bump_foil.height_reference = \"overall\", or remove it");
  checks.require(foil.truss == TrussOverrides{}, own, value,
                 "conflicts with constants of a truss, which apply to all strips", "remove it or [bump_foil.truss]");
  const auto errors_with = [&](const BumpFoil& alike) {
    Checks alone;
    check_bump_foil(alone, alike, radius);
    return alone.take();
  };
  if (!errors_with(foil).empty()) return;
  constexpr std::string_view section_of_all = "bump_foil.section";
  for (const CommandError& found : errors_with(with_bumps_of(foil, strip))) {
    const InputError& error = found.error;
    if (error.key.starts_with(section_of_all)) {
      checks.require(false, sections + error.key.substr(section_of_all.size()), error.value, error.what, error.advice);
    } else {
      checks.require(false, own, value, fmt::format("does not fit: {} {}", error.key, error.what), error.advice);
    }
  }
}

/// Checks requirements of staggered strips.
void check_staggered(Checks& checks, const PadDesign& pad, const CheckedBumpFoil& checked, double radius) {
  const BumpFoil& foil = pad.bump_foil;
  const auto least = std::min_element(foil.strip.begin(), foil.strip.end(),
                                      [](const FoilStrip& a, const FoilStrip& b) { return a.sixths() < b.sixths(); });
  checks.require(least->sixths() == 0, fmt::format("bump_foil.strip[{}].stagger", least - foil.strip.begin() + 1),
                 quantity(least->stagger, ""), "is the smallest stagger, but not 0",
                 "measure staggers from the least staggered strip, and turn bearing.weld_angle instead");
  const std::string key = "bump_foil.strip";
  checks.require(pad.bearing.taper == 0.0, key, "", "staggers strips on a sleeve with a taper, which is not supported",
                 "remove bearing.taper, or the stagger");
  if (!checked.pitches) return;
  const std::vector<BumpShape> bumps = nominal_bumps(foil);
  const bool equal =
      std::all_of(bumps.begin(), bumps.end(), [&](const BumpShape& bump) { return bump.pitch == bumps.front().pitch; });
  checks.require(equal, key, "", "staggers strips whose pitches vary, which is not supported",
                 "give one bump_foil.pitch, or remove the stagger");
  if (radius <= 0.0 || pad.top_foil.overhang) return;  // with an overhang, checked there
  const double beyond = foil_angle(pad) - turn * (1.0 + round_off);
  checks.require(beyond <= 0.0, key, "",
                 fmt::format("staggers strips so far that the foil overlaps itself by {:.6g} m", beyond * radius),
                 "give fewer bumps, smaller pitches or a shorter top_foil.overhang");
}

/// Checks requirements of strips that differ.
void check_own(Checks& checks, const PadDesign& pad) {
  const std::string key = "bump_foil.strip";
  checks.require(pad.bump_foil.model != BumpFoilModel::former, key, "",
                 "needs a top foil, which the Le Lez (2007) model does not have", "set model = \"truss\" or \"frame\"");
  checks.require(pad.bump_foil.geometry == Geometry::linear, key, "", "is not supported with large displacements",
                 "set bump_foil.geometry = \"linear\"");
}

}  // namespace

void check_strips(Checks& checks, const PadDesign& pad, const CheckedBumpFoil& checked, double radius) {
  const BumpFoil& foil = pad.bump_foil;
  bool usable = check_gaps(checks, pad);
  checks.require(!pad.top_foil.split || foil.is_split(), "top_foil.split", "true",
                 "applies to a split bump foil, and this one is not split", "set bump_foil.strips, or remove it");
  if (foil.strip.empty()) return;
  usable =
      checks.require(!usable || foil.is_split() || !foil.has_own_strips(), "bump_foil.strip", "",
                     "applies to a split bump foil, and this one is not split", "set bump_foil.strips, or remove it") &&
      usable;
  usable = checks.require(!usable || std::cmp_equal(foil.strip.size(), foil.strips), "bump_foil.strip",
                          fmt::format("{} tables", foil.strip.size()),
                          fmt::format("there must be one for each of the {} strips", foil.strips),
                          "give all of them, from the side z < 0 on, or none") &&
           usable;
  for (std::size_t k = 0; k < foil.strip.size(); ++k) {
    const std::string key = fmt::format("bump_foil.strip[{}].", k + 1);
    usable = check_stagger(checks, key + "stagger", foil.strip[k].stagger) && usable;
    check_heights(checks, key + "height_errors", foil.strip[k].height_errors, checked.bumps ? foil.bumps : 0,
                  checked.rise);
    if (foil.strip[k].has_own_bumps()) check_own_bumps(checks, key, foil, foil.strip[k], radius);
  }
  if (!usable || !foil.has_own_strips()) return;
  check_own(checks, pad);
  if (foil.is_staggered()) check_staggered(checks, pad, checked, radius);
}

}  // namespace bumpfoil
