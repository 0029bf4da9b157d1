#include "bumpfoil/model/validation.hpp"

#include <fmt/format.h>

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
#include "model/judge.hpp"
#include "model/judge_bump_foil.hpp"
#include "model/judge_montecarlo.hpp"
#include "model/judge_pads.hpp"
#include "model/judge_strips.hpp"
#include "model/judge_top_foil.hpp"

namespace bumpfoil {
namespace {

/// Checks deviations of a radius.
void judge_deviation(Judge& judge, const std::string& key, double deviation, double radius) {
  if (!judge.finite(key, deviation, "m") || radius <= 0.0) return;
  judge.require(std::abs(deviation) <= thin * radius, key, quantity(deviation, "m"), "is too large for this radius",
                fmt::format("give at most {:.6g} m either way; is the unit right?", thin * radius));
}

/// @param part  "bearing.sleeve" or "bearing.journal"
void judge_profile(Judge& judge, const std::string& part, const RadiusProfile& profile, double radius) {
  for (std::size_t i = 0; i < profile.waves.size(); ++i) {
    const std::string table = fmt::format("{}_waviness[{}]", part, i + 1);
    judge_waves(judge, table, profile.waves[i].harmonic, profile.waves[i].amplitude, radius);
    judge.angle(table + ".phase", profile.waves[i].phase);
  }
  const std::vector<double>& deviations = profile.deviations;
  const std::string key = part + "_profile";
  judge.require(std::cmp_less_equal(deviations.size(), most_points), key, fmt::format("{} values", deviations.size()),
                "are too many", fmt::format("give at most {}", most_points));
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (radius > 0.0 && std::abs(deviations[i]) <= thin * radius) continue;  // avoids text in the usual case
    judge_deviation(judge, fmt::format("{}[{}]", key, i + 1), deviations[i], radius);
  }
}

/// @return whether the radius is known; a strip without bearing has an infinite one
bool judge_radius(Judge& judge, const Bearing& bearing, bool strip) {
  if (!bearing.is_flat()) return judge.within("bearing.radius", bearing.radius, length_range);
  if (!strip) return judge.require(false, "bearing.radius", "", "is missing", "give it, or bearing.diameter");
  return judge.require(bearing.radial_clearance == 0.0, "bearing.radius", "", "is missing, though there is a clearance",
                       "give it, or bearing.diameter; a strip alone needs neither radius nor clearance");
}

bool judge_bearing(Judge& judge, const Bearing& bearing, bool strip) {
  const bool radius = judge_radius(judge, bearing, strip);
  judge.within("bearing.axial_length", bearing.axial_length, length_range);
  judge.angle("bearing.weld_angle", bearing.weld_angle);
  if (judge.finite("bearing.radial_clearance", bearing.radial_clearance, "m") && radius) {
    const double limit = thin * bearing.radius;
    judge.require(std::abs(bearing.radial_clearance) <= limit, "bearing.radial_clearance",
                  quantity(bearing.radial_clearance, "m"), "is too large for this radius",
                  fmt::format("give at most {:.6g} m either way; is the unit right?", limit));
  }
  const double usable_radius = radius ? bearing.radius : 0.0;
  judge_profile(judge, "bearing.sleeve", bearing.sleeve, usable_radius);
  judge_profile(judge, "bearing.journal", bearing.journal, usable_radius);
  judge_deviation(judge, "bearing.taper", bearing.taper, usable_radius);
  return radius;
}

template <typename Foil>
void judge_material(Judge& judge, const std::string& table, const Foil& foil) {
  judge.within(table + ".youngs_modulus", foil.youngs_modulus, modulus_range);
  judge.within(table + ".poisson_ratio", foil.poisson_ratio, poisson_range);
  if (foil.yield_stress) judge.within(table + ".yield_stress", *foil.yield_stress, strength_range);
}

void judge_truss(Judge& judge, const TrussOverrides& truss) {
  const std::array constants{std::pair{"k1", truss.k1}, std::pair{"k2", truss.k2}, std::pair{"k3", truss.k3},
                             std::pair{"k4", truss.k4}};
  for (const auto& [name, value] : constants) {
    if (value) judge.within(std::string("bump_foil.truss.") + name, *value, stiffness_range);
  }
  if (!truss.theta_d) return;
  if (!judge.finite("bump_foil.truss.theta_d", *truss.theta_d, "rad")) return;
  judge.require(*truss.theta_d > 0.0 && *truss.theta_d < 0.25 * turn, "bump_foil.truss.theta_d",
                quantity(*truss.theta_d, "rad"), "must lie between 0 and 90 degrees",
                "give the slope of the truss's inclined springs, for example \"15.8 deg\"");
}

void judge_solver(Judge& judge, const UzawaParameters& uzawa) {
  if (uzawa.eps_alm) judge.within("solver.eps_alm", *uzawa.eps_alm, stiffness_range);
  if (uzawa.eps_f) judge.within("solver.eps_f", *uzawa.eps_f, stiffness_range);
  if (uzawa.eps_r) judge.within("solver.eps_r", *uzawa.eps_r, stiffness_range);
  if (uzawa.tau_f) judge.within("solver.tau_f", *uzawa.tau_f, {1e-18, 1e-3, "m"});
}

void judge_combination(Judge& judge, const Case& input) {
  judge.require(input.solver.chosen() == SolverName::newton || input.bump_foil.model != BumpFoilModel::former,
                "solver.name", std::string(name_of(input.solver.chosen())),
                "the Le Lez (2007) model has no increments of contact to solve", "leave it out");
  judge.require(input.bearing.is_round() || input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
                std::string(name_of(input.bump_foil.model)), "supports round sleeves and journals only",
                "set model = \"truss\" or \"frame\", or remove waves, profiles and taper of [bearing]");
  judge.require_history("montecarlo", !input.montecarlo || input.bump_foil.model != BumpFoilModel::former,
                        "is not available for ensembles: its loops have no area");
  judge.require_for("montecarlo",
                    !input.montecarlo || input.montecarlo->command != EnsembleCommand::equilibrium || input.equilibrium,
                    "montecarlo.command", std::string(name_of(EnsembleCommand::equilibrium)),
                    "needs the table [equilibrium], which is missing", "add [equilibrium], or set command = \"cycle\"");
  judge.require_for(
      "montecarlo",
      !input.montecarlo || !input.montecarlo->limits || input.montecarlo->command == EnsembleCommand::equilibrium,
      "montecarlo.limits", "true", "are those of running bearings", "set command = \"equilibrium\"");
  judge.require(input.bump_foil.weld_at == WeldPosition::mid_flat || input.bump_foil.model == BumpFoilModel::frame,
                "bump_foil.weld_at", std::string(name_of(input.bump_foil.weld_at)),
                "only the frame model can be welded at the start of the first arc",
                "set weld_at = \"mid_flat\" or model = \"frame\"");
  judge.require(!input.bump_foil.stiffness_follows_height || input.bump_foil.model == BumpFoilModel::frame,
                "bump_foil.stiffness_follows_height", "true", "only the frame model has bumps of different stiffness",
                "set it to false or model = \"frame\"");
  if (input.bump_foil.geometry == Geometry::linear) return;
  judge.require(input.bump_foil.model == BumpFoilModel::frame, "bump_foil.geometry",
                std::string(name_of(input.bump_foil.geometry)), "only the frame model can follow large displacements",
                "set geometry = \"linear\" or model = \"frame\"");
  judge.require(
      input.solver.chosen() == SolverName::newton, "solver.name", std::string(name_of(input.solver.chosen())),
      input.solver.chosen() == SolverName::uzawa
          ? "solves linear elastic forces only, and bump_foil.geometry is nonlinear"
          : "follows a response that is linear between events, and with bump_foil.geometry = nonlinear it is not",
      "set name = \"newton\" or bump_foil.geometry = \"linear\"");
}

/// Whether any of these errors affects all commands.
bool any_concerns_all(const std::vector<JudgedFault>& faults) {
  return std::any_of(faults.begin(), faults.end(), [](const JudgedFault& one) { return one.command.empty(); });
}

/// Errors of a single pad, excluding those of the bearing.
std::vector<JudgedFault> find_faults_of_pad(Case alone, std::size_t pad, double lobe,
                                            const std::vector<JudgedFault>& known) {
  if (alone.top_foil.formed_radius.to == FormedTo::seated && alone.bearing.radial_clearance > 0.0) {
    alone.top_foil.formed_radius = {FormedTo::radius, formed_radius(alone.top_foil.formed_radius, alone.bearing)};
  }
  // On a preloaded pad the journal flattens the bumps at a smaller displacement.
  alone.bearing.radial_clearance -= std::max(lobe, 0.0);
  std::vector<JudgedFault> faults = judge_case(alone);
  std::erase_if(faults, [&known](const JudgedFault& found) {
    return std::any_of(known.begin(), known.end(), [&found](const JudgedFault& one) {
      return one.command == found.command && one.fault.key == found.fault.key;
    });
  });
  for (auto& [command, fault] : faults) {
    const bool of_foil = fault.key.starts_with("bump_foil") || fault.key.starts_with("top_foil");
    if (of_foil) fault.key = fmt::format("pad[{}].{}", pad + 1, fault.key);
  }
  return faults;
}

/// Errors of the foils of pads, first as given, then stretched to their arcs.
std::vector<JudgedFault> find_pad_faults(const Case& input, const std::vector<JudgedFault>& known) {
  std::vector<JudgedFault> faults;
  const auto add = [&](const PadDesign& pad, std::size_t k) {
    Case alone = input;
    static_cast<PadDesign&>(alone) = pad;
    alone.pads.clear();
    alone.rotor_bearings.clear();
    alone.bearing.pad_gap.reset();
    std::vector<JudgedFault> more = find_faults_of_pad(alone, k, input.pads[k].lobe, known);
    faults.insert(faults.end(), more.begin(), more.end());
  };
  for (std::size_t k = 0; k < input.pads.size(); ++k) {
    PadDesign pad = input;
    pad.bump_foil = bump_foil_of(input, k);
    pad.top_foil = input.pads[k].top_foil.value_or(input.top_foil);
    add(pad, k);
  }
  // Errors that affect all commands in a pad would recur in the placed pad.
  if (any_concerns_all(faults) || any_concerns_all(known)) return faults;
  faults.clear();
  const std::vector<PlacedPad> pads = place_pads(input);
  for (std::size_t k = 0; k < pads.size(); ++k) add(pads[k].alone, k);
  if (any_concerns_all(faults)) return faults;
  Judge judge;
  judge_overlaps(judge, input, pads);
  std::vector<JudgedFault> overlaps = judge.take();
  faults.insert(faults.end(), overlaps.begin(), overlaps.end());
  return faults;
}

/// Errors of the bearing of the case, and of the requested runs.
std::vector<JudgedFault> judge_bearing_and_runs(const Case& input, std::vector<CheckedKey>* checked = nullptr) {
  Judge judge(checked);
  const BumpFoil& foil = input.bump_foil;
  const bool strip = std::any_of(case_tables().begin(), case_tables().end(),
                                 [&](const CaseTable& table) { return table.flat && table.given(input); });
  const bool radius = judge_bearing(judge, input.bearing, strip);
  const double usable_radius = radius ? input.bearing.radius : 0.0;

  judge_material(judge, "bump_foil", foil);
  const JudgedBumpFoil judged = judge_bump_foil(judge, foil, usable_radius);
  judge_truss(judge, foil.truss);

  if (foil.model != BumpFoilModel::former) {
    const TopFoil& top = input.top_foil;
    judge_material(judge, "top_foil", top);
    if (judge.within("top_foil.thickness", top.thickness, length_range) && radius) {
      judge_thinness(judge, "top_foil.thickness", top.thickness, usable_radius);
    }
    judge_top_foil(judge, input, judged, usable_radius);
  }
  judge_strips(judge, input, judged, usable_radius);
  judge.within("friction.top_bump", input.friction.top_bump, coefficient_range);
  judge.within("friction.bump_sleeve", input.friction.bump_sleeve, coefficient_range);
  judge_solver(judge, input.solver.uzawa);
  for (const CaseTable& table : case_tables()) table.check(judge, input, judged);
  if (input.montecarlo) judge_montecarlo(judge, *input.montecarlo, usable_radius);
  judge_combination(judge, input);
  const bool placed = judge_pads(judge, input, usable_radius);
  std::vector<JudgedFault> faults = judge.take();
  if (!placed) return faults;
  std::vector<JudgedFault> more = find_pad_faults(input, faults);
  faults.insert(faults.end(), more.begin(), more.end());
  return faults;
}

/// Errors of the bearings of a rotor, excluding those of the bearing of the case.
std::vector<JudgedFault> find_rotor_bearing_faults(const Case& input, const std::vector<JudgedFault>& known) {
  std::vector<JudgedFault> faults;
  const auto is_known = [&known](const JudgedFault& found) {
    return std::any_of(known.begin(), known.end(), [&found](const JudgedFault& one) {
      return one.command == found.command && format_fault(one.fault) == format_fault(found.fault);
    });
  };
  for (std::size_t i = 0; i < input.rotor_bearings.size(); ++i) {
    const Case alone = bearing_at(input, i);
    for (JudgedFault& found : judge_bearing_and_runs(alone)) {
      if (is_known(found)) continue;
      found.fault.key = fmt::format("rotor.bearing[{}].{}", i + 1, found.fault.key);
      faults.push_back(std::move(found));
    }
    if (!input.montecarlo || !input.montecarlo->bump_height) continue;
    // Height errors are drawn once, for the bumps of the case: every bearing needs the same number.
    const int bumps = total_bumps(alone);
    if (bumps == total_bumps(input)) continue;
    faults.push_back(
        {"montecarlo",
         {"", 0, fmt::format("rotor.bearing[{}].bump_foil.bumps", i + 1), "",
          fmt::format("makes {} bumps, but heights are drawn for the {} of the case", bumps, total_bumps(input)),
          "give all bearings as many bumps, or remove montecarlo.bump_height"}});
  }
  return faults;
}

}  // namespace

std::vector<JudgedFault> judge_case(const Case& input) {
  std::vector<JudgedFault> faults = judge_bearing_and_runs(input);
  const std::vector<JudgedFault> more = find_rotor_bearing_faults(input, faults);
  faults.insert(faults.end(), more.begin(), more.end());
  return faults;
}

std::vector<CheckedKey> checked_keys(const Case& input) {
  std::vector<CheckedKey> checked;
  static_cast<void>(judge_bearing_and_runs(input, &checked));
  return checked;
}

std::vector<Fault> find_faults(const Case& input, const std::vector<std::string>& commands) {
  std::vector<Fault> faults;
  for (const JudgedFault& one : judge_case(input)) {
    const bool meets = std::find(commands.begin(), commands.end(), one.command) != commands.end();
    if (one.command.empty() || meets) faults.push_back(one.fault);
  }
  return faults;
}

void require_valid(const Case& input, const std::vector<std::string>& commands) {
  std::vector<Fault> faults = find_faults(input, commands);
  if (!faults.empty()) throw Error(ErrorKind::input, std::move(faults));
}

void require_bearing(const Case& input, const std::vector<std::string>& commands) {
  require_valid(input, commands);
  if (!input.bearing.is_flat()) return;
  throw Error(ErrorKind::input,
              {{"", 0, "bearing.radius", "", "is missing", "give it, or bearing.diameter: only a strip needs none"}});
}

}  // namespace bumpfoil
