#include "bumpfoil/model/validation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>

#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "model/case_table.hpp"
#include "model/check_bump_foil.hpp"
#include "model/check_montecarlo.hpp"
#include "model/check_pads.hpp"
#include "model/check_strips.hpp"
#include "model/check_top_foil.hpp"
#include "model/checks.hpp"

namespace bumpfoil {
namespace {

/// Checks deviations of a radius.
void check_deviation(Checks& checks, const std::string& key, double deviation, double radius) {
  if (!checks.finite(key, deviation, "m") || radius <= 0.0) return;
  checks.require(std::abs(deviation) <= thin * radius, key, quantity(deviation, "m"), "is too large for this radius",
                 fmt::format("give at most {:.6g} m either way; is the unit right?", thin * radius));
}

/// @param part  "bearing.sleeve" or "bearing.journal"
void check_profile(Checks& checks, const std::string& part, const RadiusProfile& profile, double radius) {
  for (std::size_t i = 0; i < profile.waves.size(); ++i) {
    const std::string table = fmt::format("{}_waviness[{}]", part, i + 1);
    check_waves(checks, table, profile.waves[i].harmonic, profile.waves[i].amplitude, radius);
    checks.angle(table + ".phase", profile.waves[i].phase);
  }
  const std::vector<double>& deviations = profile.deviations;
  const std::string key = part + "_profile";
  checks.require(std::cmp_less_equal(deviations.size(), most_points), key, fmt::format("{} values", deviations.size()),
                 "are too many", fmt::format("give at most {}", most_points));
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (radius > 0.0 && std::abs(deviations[i]) <= thin * radius) continue;  // avoids text in the usual case
    check_deviation(checks, fmt::format("{}[{}]", key, i + 1), deviations[i], radius);
  }
}

/// @return whether the radius is known; a strip without bearing has an infinite one
bool check_radius(Checks& checks, const Bearing& bearing, bool strip) {
  if (!bearing.is_flat()) return checks.within("bearing.radius", bearing.radius, length_range);
  if (!strip) return checks.require(false, "bearing.radius", "", "is missing", "give it, or bearing.diameter");
  return checks.require(bearing.radial_clearance == 0.0, "bearing.radius", "",
                        "is missing, though there is a clearance",
                        "give it, or bearing.diameter; a strip alone needs neither radius nor clearance");
}

bool check_bearing(Checks& checks, const Bearing& bearing, bool strip) {
  const bool radius = check_radius(checks, bearing, strip);
  checks.within("bearing.axial_length", bearing.axial_length, length_range);
  checks.angle("bearing.weld_angle", bearing.weld_angle);
  if (checks.finite("bearing.radial_clearance", bearing.radial_clearance, "m") && radius) {
    const double limit = thin * bearing.radius;
    checks.require(std::abs(bearing.radial_clearance) <= limit, "bearing.radial_clearance",
                   quantity(bearing.radial_clearance, "m"), "is too large for this radius",
                   fmt::format("give at most {:.6g} m either way; is the unit right?", limit));
  }
  const double usable_radius = radius ? bearing.radius : 0.0;
  check_profile(checks, "bearing.sleeve", bearing.sleeve, usable_radius);
  check_profile(checks, "bearing.journal", bearing.journal, usable_radius);
  check_deviation(checks, "bearing.taper", bearing.taper, usable_radius);
  return radius;
}

template <typename Foil>
void check_material(Checks& checks, const std::string& table, const Foil& foil) {
  checks.within(table + ".youngs_modulus", foil.youngs_modulus, modulus_range);
  checks.within(table + ".poisson_ratio", foil.poisson_ratio, poisson_range);
  if (foil.yield_stress) checks.within(table + ".yield_stress", *foil.yield_stress, strength_range);
}

void check_truss(Checks& checks, const TrussOverrides& truss) {
  const std::array constants{std::pair{"k1", truss.k1}, std::pair{"k2", truss.k2}, std::pair{"k3", truss.k3},
                             std::pair{"k4", truss.k4}};
  for (const auto& [name, value] : constants) {
    if (value) checks.within(std::string("bump_foil.truss.") + name, *value, stiffness_range);
  }
  if (!truss.theta_d) return;
  if (!checks.finite("bump_foil.truss.theta_d", *truss.theta_d, "rad")) return;
  checks.require(*truss.theta_d > 0.0 && *truss.theta_d < 0.25 * turn, "bump_foil.truss.theta_d",
                 quantity(*truss.theta_d, "rad"), "must lie between 0 and 90 degrees",
                 "give the slope of the truss's inclined springs, for example \"15.8 deg\"");
}

void check_solver(Checks& checks, const UzawaParameters& uzawa) {
  if (uzawa.eps_alm) checks.within("solver.eps_alm", *uzawa.eps_alm, stiffness_range);
  if (uzawa.eps_f) checks.within("solver.eps_f", *uzawa.eps_f, stiffness_range);
  if (uzawa.eps_r) checks.within("solver.eps_r", *uzawa.eps_r, stiffness_range);
  if (uzawa.tau_f) checks.within("solver.tau_f", *uzawa.tau_f, {1e-18, 1e-3, "m"});
}

void check_ensemble_command(Checks& checks, const Case& input) {
  const std::string& command = input.montecarlo->command;
  const CaseTable* const run = case_table_of(command);
  const bool known = run != nullptr && run->sampled_by;
  checks.require(known, "montecarlo.command", command, "is not a command that ensembles run",
                 fmt::format("give one of {}", fmt::join(sampled_experiments(), ", ")));
  if (!known) return;
  checks.require_for("montecarlo", !run->given || run->given(input), "montecarlo.command", command,
                     fmt::format("needs the table [{}], which is missing", run->needs),
                     fmt::format("add [{}], or set another command", run->needs));
}

void check_combination(Checks& checks, const Case& input) {
  checks.require(input.solver.chosen() == SolverName::newton || input.bump_foil.model != BumpFoilModel::former,
                 "solver.name", std::string(name_of(input.solver.chosen())),
                 "the Le Lez (2007) model has no increments of contact to solve", "leave it out");
  checks.require(input.bearing.is_round() || input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
                 std::string(name_of(input.bump_foil.model)), "supports round sleeves and journals only",
                 "set model = \"truss\" or \"frame\", or remove waves, profiles and taper of [bearing]");
  checks.require_history("montecarlo", !input.montecarlo || input.bump_foil.model != BumpFoilModel::former,
                         "is not available for ensembles: its loops have no area");
  if (input.montecarlo) check_ensemble_command(checks, input);
  checks.require(input.bump_foil.weld_at == WeldPosition::mid_flat || input.bump_foil.model == BumpFoilModel::frame,
                 "bump_foil.weld_at", std::string(name_of(input.bump_foil.weld_at)),
                 "only the frame model can be welded at the start of the first arc",
                 "set weld_at = \"mid_flat\" or model = \"frame\"");
  checks.require(!input.bump_foil.stiffness_follows_height || input.bump_foil.model == BumpFoilModel::frame,
                 "bump_foil.stiffness_follows_height", "true", "only the frame model has bumps of different stiffness",
                 "set it to false or model = \"frame\"");
  if (input.bump_foil.geometry == Geometry::linear) return;
  checks.require(input.bump_foil.model == BumpFoilModel::frame, "bump_foil.geometry",
                 std::string(name_of(input.bump_foil.geometry)), "only the frame model can follow large displacements",
                 "set geometry = \"linear\" or model = \"frame\"");
  checks.require(
      input.solver.chosen() == SolverName::newton, "solver.name", std::string(name_of(input.solver.chosen())),
      input.solver.chosen() == SolverName::uzawa
          ? "solves linear elastic forces only, and bump_foil.geometry is nonlinear"
          : "follows a response that is linear between events, and with bump_foil.geometry = nonlinear it is not",
      "set name = \"newton\" or bump_foil.geometry = \"linear\"");
}

/// Whether any of these errors affects all commands.
bool any_concerns_all(const std::vector<CommandError>& errors) {
  return std::any_of(errors.begin(), errors.end(), [](const CommandError& one) { return one.command.empty(); });
}

/// Errors of a single pad, excluding those of the bearing.
std::vector<CommandError> find_errors_of_pad(Case alone, std::size_t pad, double lobe,
                                             const std::vector<CommandError>& known) {
  if (alone.top_foil.formed_radius.to == FormedTo::seated && alone.bearing.radial_clearance > 0.0) {
    alone.top_foil.formed_radius = {FormedTo::radius, formed_radius(alone.top_foil.formed_radius, alone.bearing)};
  }
  // On a preloaded pad the journal flattens the bumps at a smaller displacement.
  alone.bearing.radial_clearance -= std::max(lobe, 0.0);
  std::vector<CommandError> errors = check_case(alone);
  std::erase_if(errors, [&known](const CommandError& found) {
    return std::any_of(known.begin(), known.end(), [&found](const CommandError& one) {
      return one.command == found.command && one.error.key == found.error.key;
    });
  });
  for (auto& [command, error] : errors) {
    const bool of_foil = error.key.starts_with("bump_foil") || error.key.starts_with("top_foil");
    if (of_foil) error.key = fmt::format("pad[{}].{}", pad + 1, error.key);
  }
  return errors;
}

/// Errors of the foils of pads, first as given, then stretched to their arcs.
std::vector<CommandError> find_pad_errors(const Case& input, const std::vector<CommandError>& known) {
  std::vector<CommandError> errors;
  const auto add = [&](const PadDesign& pad, std::size_t k) {
    Case alone = input;
    static_cast<PadDesign&>(alone) = pad;
    alone.pads.clear();
    alone.rotor_bearings.clear();
    alone.bearing.pad_gap.reset();
    std::vector<CommandError> more = find_errors_of_pad(alone, k, input.pads[k].lobe, known);
    errors.insert(errors.end(), more.begin(), more.end());
  };
  for (std::size_t k = 0; k < input.pads.size(); ++k) {
    PadDesign pad = input;
    pad.bump_foil = bump_foil_of(input, k);
    pad.top_foil = input.pads[k].top_foil.value_or(input.top_foil);
    add(pad, k);
  }
  // Errors that affect all commands in a pad would recur in the placed pad.
  if (any_concerns_all(errors) || any_concerns_all(known)) return errors;
  errors.clear();
  const std::vector<PlacedPad> pads = place_pads(input);
  for (std::size_t k = 0; k < pads.size(); ++k) add(pads[k].alone, k);
  if (any_concerns_all(errors)) return errors;
  Checks checks;
  check_overlaps(checks, input, pads);
  std::vector<CommandError> overlaps = checks.take();
  errors.insert(errors.end(), overlaps.begin(), overlaps.end());
  return errors;
}

/// Errors of the bearing of the case, and of the requested runs.
std::vector<CommandError> check_bearing_and_runs(const Case& input, std::vector<CheckedKey>* checked = nullptr) {
  Checks checks(checked);
  const BumpFoil& foil = input.bump_foil;
  const bool strip = std::any_of(case_tables().begin(), case_tables().end(),
                                 [&](const CaseTable& table) { return table.flat && table.given(input); });
  const bool radius = check_bearing(checks, input.bearing, strip);
  const double usable_radius = radius ? input.bearing.radius : 0.0;

  check_material(checks, "bump_foil", foil);
  const CheckedBumpFoil bumps = check_bump_foil(checks, foil, usable_radius);
  check_truss(checks, foil.truss);

  if (foil.model != BumpFoilModel::former) {
    const TopFoil& top = input.top_foil;
    check_material(checks, "top_foil", top);
    if (checks.within("top_foil.thickness", top.thickness, length_range) && radius) {
      check_thinness(checks, "top_foil.thickness", top.thickness, usable_radius);
    }
    check_top_foil(checks, input, bumps, usable_radius);
  }
  check_strips(checks, input, bumps, usable_radius);
  checks.within("friction.top_bump", input.friction.top_bump, coefficient_range);
  checks.within("friction.bump_sleeve", input.friction.bump_sleeve, coefficient_range);
  check_solver(checks, input.solver.uzawa);
  for (const CaseTable& table : case_tables()) table.check(checks, input, bumps);
  if (input.montecarlo) check_montecarlo(checks, *input.montecarlo, usable_radius);
  check_combination(checks, input);
  const bool placed = check_pads(checks, input, usable_radius);
  std::vector<CommandError> errors = checks.take();
  if (!placed) return errors;
  std::vector<CommandError> more = find_pad_errors(input, errors);
  errors.insert(errors.end(), more.begin(), more.end());
  return errors;
}

/// Errors of the bearings of a rotor, excluding those of the bearing of the case.
std::vector<CommandError> find_rotor_bearing_errors(const Case& input, const std::vector<CommandError>& known) {
  std::vector<CommandError> errors;
  const auto is_known = [&known](const CommandError& found) {
    return std::any_of(known.begin(), known.end(), [&found](const CommandError& one) {
      return one.command == found.command && format_error(one.error) == format_error(found.error);
    });
  };
  for (std::size_t i = 0; i < input.rotor_bearings.size(); ++i) {
    const Case alone = bearing_at(input, i);
    for (CommandError& found : check_bearing_and_runs(alone)) {
      if (is_known(found)) continue;
      found.error.key = fmt::format("rotor.bearing[{}].{}", i + 1, found.error.key);
      errors.push_back(std::move(found));
    }
    if (!input.montecarlo || !input.montecarlo->bump_height) continue;
    // Height errors are drawn once, for the bumps of the case: every bearing needs the same number.
    const int bumps = total_bumps(alone);
    if (bumps == total_bumps(input)) continue;
    errors.push_back(
        {"montecarlo",
         {"", 0, fmt::format("rotor.bearing[{}].bump_foil.bumps", i + 1), "",
          fmt::format("makes {} bumps, but heights are drawn for the {} of the case", bumps, total_bumps(input)),
          "give all bearings as many bumps, or remove montecarlo.bump_height"}});
  }
  return errors;
}

}  // namespace

std::vector<CommandError> check_case(const Case& input) {
  std::vector<CommandError> errors = check_bearing_and_runs(input);
  const std::vector<CommandError> more = find_rotor_bearing_errors(input, errors);
  errors.insert(errors.end(), more.begin(), more.end());
  return errors;
}

std::vector<CheckedKey> checked_keys(const Case& input) {
  std::vector<CheckedKey> checked;
  static_cast<void>(check_bearing_and_runs(input, &checked));
  return checked;
}

std::vector<InputError> find_errors(const Case& input, const std::vector<std::string>& commands) {
  std::vector<InputError> errors;
  for (const CommandError& one : check_case(input)) {
    const bool meets = std::find(commands.begin(), commands.end(), one.command) != commands.end();
    if (one.command.empty() || meets) errors.push_back(one.error);
  }
  return errors;
}

void require_valid(const Case& input, const std::vector<std::string>& commands) {
  std::vector<InputError> errors = find_errors(input, commands);
  if (!errors.empty()) throw Error(ErrorKind::input, std::move(errors));
}

void require_bearing(const Case& input, const std::vector<std::string>& commands) {
  require_valid(input, commands);
  if (!input.bearing.is_flat()) return;
  throw Error(ErrorKind::input,
              {{"", 0, "bearing.radius", "", "is missing", "give it, or bearing.diameter: only a strip needs none"}});
}

}  // namespace bumpfoil
