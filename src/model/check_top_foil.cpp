#include "model/check_top_foil.hpp"

#include <fmt/format.h>

#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// Smallest formed radius relative to that of the bearing, and largest pressure on the bumps: values beyond indicate a
/// wrong unit.
constexpr double tightest = 0.5;
constexpr Range seat_range{0.0, 1e6, "Pa"};
/// Overhangs over the last pitch: shorter ones cannot be meshed, longer ones are not supported.
constexpr double shortest_overhang = 0.01;
constexpr double longest_overhang = 2.0;

void check_forming(Checks& checks, const PadDesign& pad, double radius) {
  const FormedRadius& formed = pad.top_foil.formed_radius;
  const double clearance = pad.bearing.radial_clearance;
  if (formed.to == FormedTo::seated) {
    checks.require(clearance > 0.0, "top_foil.formed_radius", "seated",
                   fmt::format("needs a clearance, and bearing.radial_clearance is {}", quantity(clearance, "m")),
                   "give a length, or a radial clearance above zero");
  }
  if (formed.to == FormedTo::radius && checks.within("top_foil.formed_radius", formed.radius, length_range) &&
      radius > 0.0) {
    checks.require(formed.radius >= tightest * radius, "top_foil.formed_radius", quantity(formed.radius, "m"),
                   fmt::format("is far less than the radius of the bearing, {}", quantity(radius, "m")),
                   fmt::format("give {} at least; is the unit right?", quantity(tightest * radius, "m")));
  }
  if (pad.top_foil.seat_pressure) checks.within("top_foil.seat_pressure", *pad.top_foil.seat_pressure, seat_range);
}

void check_overhang(Checks& checks, const PadDesign& pad, double overhang, double radius) {
  const double pitch = nominal_bumps(pad.bump_foil).back().pitch;
  const bool usable =
      checks.require(overhang >= shortest_overhang * pitch && overhang <= longest_overhang * pitch, "top_foil.overhang",
                     quantity(overhang, "m"), fmt::format("does not fit the last pitch, {}", quantity(pitch, "m")),
                     fmt::format("give a length from {} to {}", quantity(shortest_overhang * pitch, "m"),
                                 quantity(longest_overhang * pitch, "m")));
  if (!usable || radius <= 0.0) return;
  const double arc = foil_angle(pad);
  checks.require(arc <= turn * (1.0 + round_off), "top_foil.overhang", quantity(overhang, "m"),
                 fmt::format("makes the foil overlap itself: it ends {:.6g} degrees from the weld", 360.0 / turn * arc),
                 fmt::format("give {} at most", quantity(overhang - (arc - turn) * radius, "m")));
}

}  // namespace

void check_top_foil(Checks& checks, const PadDesign& pad, const CheckedBumpFoil& foil, double radius) {
  check_forming(checks, pad, radius);
  const std::optional<double>& overhang = pad.top_foil.overhang;
  if (!overhang || !checks.finite("top_foil.overhang", *overhang, "m") || !foil.pitches) return;
  check_overhang(checks, pad, *overhang, radius);
}

}  // namespace bumpfoil
