#include "pages/shown_deviations.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "core/base64.hpp"

namespace bumpfoil {
namespace {

/// Half a degree: smooth for waves of any order drawn on a bearing.
constexpr std::size_t parts = 720;

/// Increase of the sleeve radius by its taper at a polar angle, m; NaN between foils.
double taper_at(const Case& input, const std::vector<PlacedPad>& pads, double phi) {
  for (const PlacedPad& pad : pads) {
    const double turns = pad.sense() * (phi - pad.alone.bearing.weld_angle) / turn;
    const double theta = turn * (turns - std::floor(turns));
    if (theta <= pad.arc) return input.bearing.taper * theta / pad.arc;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

nlohmann::ordered_json shown_deviations(const Case& input) {
  const Bearing& bearing = input.bearing;
  if (bearing.is_round() || bearing.is_flat()) return nullptr;
  const std::vector<PlacedPad> pads = place_pads(input);
  std::vector<double> sleeve, journal, taper;
  for (std::size_t i = 0; i <= parts; ++i) {
    const double phi = turn * static_cast<double>(i) / static_cast<double>(parts);
    journal.push_back(deviation_at(bearing.journal, phi));
    taper.push_back(bearing.taper == 0.0 ? 0.0 : taper_at(input, pads, phi));
    sleeve.push_back(deviation_at(bearing.sleeve, phi) + taper.back());
  }
  nlohmann::ordered_json json;
  if (bearing.sleeve != RadiusProfile{} || bearing.taper != 0.0) json["sleeve"] = base64_of(sleeve);
  if (bearing.taper != 0.0 && bearing.sleeve != RadiusProfile{}) json["taper"] = base64_of(taper);
  if (bearing.journal != RadiusProfile{}) json["journal"] = base64_of(journal);
  return json;
}

}  // namespace bumpfoil
