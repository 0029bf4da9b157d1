#include "model/check_pads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"

namespace bumpfoil {
namespace {

std::string degrees(double angle) {
  return fmt::format("{:.6g} deg", 360.0 / turn * angle);
}

/// Checks properties that the foils of all pads must share: one contact problem and one result hold all of them.
void check_common(Checks& checks, const std::string& table, const Case& input, const Pad& pad) {
  const auto require_same = [&](bool same, std::string_view key, std::string_view common) {
    checks.require(same, fmt::format("{}.{}", table, key), "", "is not that of the other pads",
                   fmt::format("leave it out here, and give {}", common));
  };
  if (pad.bump_foil) {
    require_same(pad.bump_foil->model == input.bump_foil.model, "bump_foil.model", "bump_foil.model for all");
    require_same(pad.bump_foil->geometry == input.bump_foil.geometry, "bump_foil.geometry",
                 "bump_foil.geometry for all");
    require_same(pad.bump_foil->strips == input.bump_foil.strips, "bump_foil.strips", "bump_foil.strips for all");
    require_same(pad.bump_foil->strip_gap == input.bump_foil.strip_gap, "bump_foil.strip_gap",
                 "bump_foil.strip_gap for all");
    const auto same_stagger = [](const FoilStrip& a, const FoilStrip& b) { return a.sixths() == b.sixths(); };
    require_same(std::equal(pad.bump_foil->strip.begin(), pad.bump_foil->strip.end(), input.bump_foil.strip.begin(),
                            input.bump_foil.strip.end(), same_stagger),
                 "bump_foil.strip", "the stagger of bump_foil.strip for all");
    require_same(pad.bump_foil->yield_stress == input.bump_foil.yield_stress, "bump_foil.yield_stress",
                 "bump_foil.yield_stress for all");
  }
  if (pad.top_foil) {
    require_same(pad.top_foil->split == input.top_foil.split, "top_foil.split", "top_foil.split for all");
    require_same(pad.top_foil->yield_stress == input.top_foil.yield_stress, "top_foil.yield_stress",
                 "top_foil.yield_stress for all");
  }
}

/// Checks for commands and models that support only one foil around the circumference.
void check_use(Checks& checks, const Case& input) {
  checks.require(input.bump_foil.model != BumpFoilModel::former, "bump_foil.model", "", "does not support pads",
                 "set model = \"truss\" or \"frame\", or remove [[pad]]");
}

}  // namespace

bool check_pads(Checks& checks, const Case& input, double radius) {
  const auto& gap = input.bearing.pad_gap;
  if (input.pads.empty()) {
    checks.require(!gap, "bearing.pad_gap", "", "applies between pads, but there are none",
                   "remove it, or add [[pad]]");
    return false;
  }
  check_use(checks, input);
  const double share = turn / static_cast<double>(input.pads.size());
  bool placed = !gap || (checks.finite("bearing.pad_gap", *gap, "rad") &&
                         checks.require(*gap >= 0.0 && *gap < share, "bearing.pad_gap", degrees(*gap),
                                        fmt::format("leaves no arc of the share of a pad, {}", degrees(share)),
                                        "give a smaller gap, which is not negative"));
  for (std::size_t k = 0; k < input.pads.size(); ++k) {
    const Pad& pad = input.pads[k];
    const std::string table = fmt::format("pad[{}]", k + 1);
    if (pad.weld_angle) placed = checks.angle(table + ".weld_angle", *pad.weld_angle) && placed;
    if (pad.arc) {
      placed = checks.angle(table + ".arc", *pad.arc) &&
               checks.require(*pad.arc > 0.0, table + ".arc", degrees(*pad.arc), "must be positive",
                              "give the angle from the weld to the free end") &&
               placed;
    }
    placed = checks.finite(table + ".lobe", pad.lobe, "m") &&
             (radius <= 0.0 ||
              checks.require(std::abs(pad.lobe) <= thin * radius, table + ".lobe", quantity(pad.lobe, "m"),
                             "is too large for this radius",
                             fmt::format("give at most {:.6g} m either way; is the unit right?", thin * radius))) &&
             placed;
    check_common(checks, table, input, pad);
  }
  return placed;
}

void check_overlaps(Checks& checks, const Case& input, const std::vector<PlacedPad>& pads) {
  struct Cover {
    std::size_t pad;
    double from, arc;  // in the foil direction of the bearing
  };
  const double sense = input.bearing.wrap == Wrap::clockwise ? -1.0 : 1.0;
  std::vector<Cover> covers;
  covers.reserve(pads.size());
  for (const PlacedPad& placed : pads) {
    const Bearing& bearing = placed.alone.bearing;
    const double from = sense * bearing.weld_angle - (bearing.wrap == input.bearing.wrap ? 0.0 : placed.arc);
    covers.push_back({covers.size(), from - turn * std::floor(from / turn), placed.arc});
  }
  std::sort(covers.begin(), covers.end(), [](const Cover& a, const Cover& b) { return a.from < b.from; });
  for (std::size_t i = 0; i < covers.size(); ++i) {
    const bool last = i + 1 == covers.size();
    const Cover& next = covers[last ? 0 : i + 1];
    const double over = covers[i].from + covers[i].arc - next.from - (last ? turn : 0.0);
    checks.require(over <= turn * round_off, fmt::format("pad[{}]", std::max(covers[i].pad, next.pad) + 1), "",
                   fmt::format("overlaps pad {} by {}", std::min(covers[i].pad, next.pad) + 1, degrees(over)),
                   "give fewer bumps, smaller arcs, or other weld angles");
  }
}

}  // namespace bumpfoil
