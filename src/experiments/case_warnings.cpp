#include "bumpfoil/experiments/case_warnings.hpp"

#include <fmt/format.h>

#include <optional>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/contact/wedging.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

/// Formed radii beyond this multiple of the bearing's yield trends only: displacements of the assembled foil are no
/// longer small, and its bumps affect its shape.
constexpr double most_flattening = 1.25;

/// Axial length over diameter above which the sheet of a bump foil yields to variations over the width.
constexpr double longest_held_sheet = 1.2;

/// Warns of foils modelled too simply over the width.
void warn_of_width(const Case& input, std::vector<std::string>& warnings) {
  if ((input.width.tilts() || input.width.conicity != 0.0) && input.width.modes == 1) {
    warnings.emplace_back(
        "the journal may tilt or is conical, but the foils stay uniform over the width (width.modes = 1): they resist "
        "the tilt with about twice the true moment; set width.modes = 3");
  }
  const double slenderness = 0.5 * input.bearing.axial_length / input.bearing.radius;
  if (input.width.modes >= 3 && !input.width.sheet && !input.bump_foil.is_split() && slenderness > longest_held_sheet) {
    warnings.push_back(fmt::format(
        "the bearing is {:.3g} times as long as its diameter: with width.modes = {} the feet of its bump foil cannot "
        "slide by different amounts over the width, which is too stiff beyond {:.3g}; set width.sheet = true",
        slenderness, input.width.modes, longest_held_sheet));
  }
}

/// Warns if friction leaves increments with several solutions or none.
void warn_of_wedging(const BearingModel& foils, std::vector<std::string>& warnings) {
  const std::optional<Wedge> wedge = strongest_wedge(foils.problem);
  if (!wedge) return;
  const int block = wedge->contact / foils.contacts_per_block();
  const bool at_sleeve = wedge->contact % foils.contacts_per_block() >= foils.first_foot();
  warnings.push_back(
      fmt::format("friction wedges {} of bump {}, which takes a coefficient of {:.3g} there: increments may have "
                  "several solutions, of which one is found, or none",
                  at_sleeve ? "a foot" : "the crest", block - foils.structure.first_bump + 1, wedge->friction));
}

std::string of_pad(const std::vector<PlacedPad>& pads, std::size_t k) {
  return pads.size() == 1 ? "" : fmt::format(" of pad {}", k + 1);
}

}  // namespace

std::vector<std::string> case_warnings(const Case& input) {
  std::vector<std::string> warnings = input.remarks;
  if (input.bearing.is_flat()) return warnings;
  warn_of_width(input, warnings);
  const std::vector<PlacedPad> pads = place_pads(input);
  std::optional<BearingModel> foils;
  const bool rubs = input.friction.top_bump > 0.0 || input.friction.bump_sleeve > 0.0;
  if (rubs && input.bump_foil.model != BumpFoilModel::former) {
    foils = foils_without_journal(input);
    warn_of_wedging(*foils, warnings);
  }
  for (std::size_t k = 0; k < pads.size(); ++k) {
    const PadDesign& alone = pads[k].alone;
    if (!is_formed(alone)) continue;
    const double radius = formed_radius(alone.top_foil.formed_radius, alone.bearing);
    const double ratio = radius / alone.bearing.radius;
    if (ratio < 1.0) {
      warnings.push_back(
          fmt::format("the top foil{} is formed tighter than the bearing, to {:.6g} mm: its free end lifts off the "
                      "bumps and closes on the journal; form it 0.5 to 1 % flatter than the bearing",
                      of_pad(pads, k), 1e3 * radius));
      continue;
    }
    if (ratio > most_flattening) {
      warnings.push_back(
          fmt::format("the top foil{} is formed {:.3g} % flatter than the bearing: beyond {:.3g} % its displacements "
                      "are no longer small, and results show trends only",
                      of_pad(pads, k), 100.0 * (ratio - 1.0), 100.0 * (most_flattening - 1.0)));
    }
    if (!foils) foils = foils_without_journal(input);
    if (foils->assembly.empty()) {
      warnings.emplace_back("the shape of the formed top foil without a journal was not found");
      break;
    }
    const double room = foils->assembled_clearance_in(k);
    if (room > 0.0) continue;
    warnings.push_back(fmt::format(
        "the top foil{} bulges by {:.4g} um where it leaves its bumps and presses on a centred journal at rest, {:.4g} "
        "um more than the assembled clearance: form it less flat",
        of_pad(pads, k), 1e6 * foils->assembly[k].bulge, -1e6 * room));
  }
  return warnings;
}

std::vector<std::string> rotor_case_warnings(const Case& input) {
  if (input.rotor_bearings.empty()) return case_warnings(input);
  std::vector<std::string> warnings = input.remarks;
  for (std::size_t i = 0; i < input.rotor_bearings.size(); ++i) {
    for (const std::string& warning : case_warnings(bearing_at(input, i))) {
      warnings.push_back(fmt::format("bearing {}: {}", i + 1, warning));
    }
  }
  return warnings;
}

}  // namespace bumpfoil
