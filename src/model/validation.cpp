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
#include "model/judge.hpp"
#include "model/judge_bump_foil.hpp"
#include "model/judge_film.hpp"
#include "model/judge_montecarlo.hpp"
#include "model/judge_pads.hpp"
#include "model/judge_vibration.hpp"

namespace bumpfoil {
namespace {

/// Deviations of a radius.
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
    if (radius > 0.0 && std::abs(deviations[i]) <= thin * radius) continue;  // the usual case costs no text
    judge_deviation(judge, fmt::format("{}[{}]", key, i + 1), deviations[i], radius);
  }
}

/// @return whether the radius is known; that of a strip alone is infinite
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

/// Whether a run of so many increments and bumps can be kept in memory.
void judge_memory(Judge& judge, std::string_view command, const std::string& key, int steps, std::int64_t increments,
                  int bumps) {
  judge.require_for(command, increments <= most_bump_increments / bumps, key, std::to_string(steps),
                    fmt::format("{} increments of {} bumps would not fit in memory", increments, bumps),
                    "give fewer steps, or fewer directions or cycles");
}

/// A direction that is given twice, or again after a full turn, would only repeat its results.
void judge_repetition(Judge& judge, const std::vector<double>& directions) {
  std::vector<std::pair<double, std::size_t>> around;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (!std::isfinite(directions[i])) continue;  // already checked
    around.emplace_back(directions[i] - turn * std::floor(directions[i] / turn + round_off), i);
  }
  std::sort(around.begin(), around.end());
  std::vector<std::pair<std::size_t, std::size_t>> again;
  for (std::size_t k = 1; k < around.size(); ++k) {
    if (around[k].first - around[k - 1].first > turn * round_off) continue;
    const auto [first, second] = std::minmax(around[k - 1].second, around[k].second);
    again.emplace_back(second, first);
  }
  std::sort(again.begin(), again.end());  // as they stand in the case, not by their angles
  for (const auto& [second, first] : again) {
    judge.require(false, fmt::format("cycle.directions[{}]", second + 1), quantity(directions[second], "rad"),
                  fmt::format("repeats cycle.directions[{}]", first + 1), "give every direction once");
  }
}

/// How far the cycles of the journal go, from their preload on; `limit`: what presses the bumps flat, 0 if not known.
void judge_course(Judge& judge, const CycleSettings& cycle, double limit) {
  const bool by_load = cycle.amplitude.control == Control::load;
  const bool amplitude = by_load ? judge.within("cycle.load", cycle.amplitude.value, load_range)
                                 : judge.within("cycle.amplitude", cycle.amplitude.value, length_range);
  double start = 0.0;
  if (cycle.preload) {
    const auto& [control, value] = *cycle.preload;
    const bool is_load = control == Control::load;
    const std::string_view unit = is_load ? "N" : "m";
    const std::string shown = fmt::format("({}, {})", quantity(value.x(), unit), quantity(value.y(), unit));
    const double most = is_load ? load_range.most : length_range.most;
    if (!judge.require(value.norm() <= most, "cycle.preload", shown, "is unphysical",
                       fmt::format("give at most {}", quantity(most, unit)))) {
      return;
    }
    judge.require(!is_load || value.norm() >= load_range.least, "cycle.preload", shown,
                  "is zero: the journal position would be undetermined",
                  "give a load, or leave it out for cycles from the centre");
    judge.require(is_load || !by_load, "cycle.preload", shown,
                  "is a displacement where the cycles are controlled by load",
                  "give a load, or cycle.amplitude in place of cycle.load");
    if (!is_load) start = value.norm();
    judge.require_for("cycle", is_load || limit <= 0.0 || start < limit, "cycle.preload", shown,
                      "would press the bumps flat",
                      fmt::format("give less than clearance and rise together, {:.6g} m", limit));
  }
  if (by_load || !amplitude || limit <= 0.0 || start >= limit) return;
  const bool flat = start + cycle.amplitude.value >= limit;
  judge.require_for("cycle", !flat, "cycle.amplitude", quantity(cycle.amplitude.value, "m"),
                    start > 0.0 ? "would press the bumps flat on top of cycle.preload" : "would press the bumps flat",
                    fmt::format("give less than clearance and rise together, {:.6g} m{}", limit,
                                start > 0.0 ? ", preload included" : ""));
}

/// Displacement of the journal that presses the bumps flat, m; 0 if it is not known.
double flattening(const Bearing& bearing, double rise) {
  const bool clear = std::abs(bearing.radial_clearance) <= thin * bearing.radius;
  return rise > 0.0 && clear ? bearing.radial_clearance + rise : 0.0;
}

void judge_cycle(Judge& judge, const Case& input, bool bumps, double rise) {
  const CycleSettings& cycle = input.cycle;
  if (cycle.directions.empty() && cycle.amplitude.value == 0.0) return;
  judge.require(!cycle.directions.empty(), "cycle.directions", "", "no direction specified",
                "give a list such as [\"+X\", \"90 deg\"]");
  for (std::size_t i = 0; i < cycle.directions.size(); ++i) {
    judge.angle(fmt::format("cycle.directions[{}]", i + 1), cycle.directions[i]);
  }
  judge_repetition(judge, cycle.directions);
  judge_course(judge, cycle, flattening(input.bearing, rise));
  const bool steps =
      judge.require(cycle.steps >= 1 && cycle.steps <= most_steps, "cycle.steps", std::to_string(cycle.steps),
                    "is not a valid number of increments", fmt::format("give a whole number from 1 to {}", most_steps));
  judge.require(cycle.cycles >= 1 && cycle.cycles <= most_steps, "cycle.cycles", std::to_string(cycle.cycles),
                "is not a valid number of cycles", fmt::format("give a whole number from 1 to {}", most_steps));
  for (std::size_t i = 0; i < cycle.clearance_forces.size(); ++i) {
    judge.within(fmt::format("cycle.clearance_forces[{}]", i + 1), cycle.clearance_forces[i], load_range);
  }
  if (!bumps || !steps) return;
  const auto increments = std::int64_t{cycle.swings() ? 4 : 2} * cycle.steps * std::ssize(cycle.directions);
  judge_memory(judge, "cycle", "cycle.steps", cycle.steps, increments, total_bumps(input));
}

/// A target of the plate, called by the key that holds it.
void judge_target(Judge& judge, const std::string& key, const Target& target, double rise) {
  if (target.control == Control::load) {
    judge.within(key, target.value, load_range);
  } else if (judge.within(key, target.value, length_range) && rise > 0.0) {
    judge.require_for("strip", target.value < rise, key, quantity(target.value, "m"), "would press the bumps flat",
                      fmt::format("give less than their rise, {:.6g} m", rise));
  }
}

void judge_strip(Judge& judge, const StripSettings& strip, const BumpFoil& foil, double rise) {
  const bool by_load = strip.amplitude.control == Control::load;
  const std::string amplitude_key = by_load ? "strip.load" : "strip.displacement";
  const bool bumps =
      judge.require(strip.bumps >= 1 && strip.bumps <= most_bumps, "strip.bumps", std::to_string(strip.bumps),
                    "is not a valid number of bumps", fmt::format("give a whole number from 1 to {}", most_bumps));
  if (bumps) judge_strip_of(judge, foil, strip.bumps);
  judge_target(judge, amplitude_key, strip.amplitude, rise);
  if (strip.preload) {
    judge_target(judge, "strip.preload", *strip.preload, rise);
    if (rise > 0.0 && !by_load && strip.preload->control == Control::displacement) {
      judge.require_for("strip", strip.preload->value + strip.amplitude.value < rise, "strip.displacement",
                        quantity(strip.amplitude.value, "m"), "would press the bumps flat on top of strip.preload",
                        fmt::format("give both less than their rise together, {:.6g} m", rise));
    }
    if (by_load) {
      judge.require(strip.preload->control == Control::load, "strip.preload", quantity(strip.preload->value, "m"),
                    "is a displacement where the strip is controlled by load",
                    "give a load, or a displacement in place of strip.load");
      judge.require(strip.preload->control != Control::load || strip.preload->value >= strip.amplitude.value,
                    "strip.preload", quantity(strip.preload->value, "N"),
                    fmt::format("is less than the amplitude, {:.6g} N: a plate cannot pull", strip.amplitude.value),
                    "give a larger preload or a smaller load");
    }
  }
  const bool cycles =
      judge.require(strip.cycles >= 1 && strip.cycles <= most_steps, "strip.cycles", std::to_string(strip.cycles),
                    "is not a valid number of cycles", fmt::format("give a whole number from 1 to {}", most_steps));
  const bool steps =
      judge.require(strip.steps >= 1 && strip.steps <= most_steps, "strip.steps", std::to_string(strip.steps),
                    "is not a valid number of increments", fmt::format("give a whole number from 1 to {}", most_steps));
  if (!bumps || !cycles || !steps) return;
  const std::int64_t branches = strip.preload ? 4 : 2;
  judge_memory(judge, "strip", "strip.steps", strip.steps, branches * strip.steps * strip.cycles, strip.bumps);
}

/// @param limit  what presses the bumps flat, 0 if not known
void judge_path(Judge& judge, const PathSettings& path, int bumps, double limit) {
  const bool by_load = path.control() == Control::load;
  const bool presses = !by_load && limit > 0.0;
  const double most = by_load ? load_range.most : presses ? limit : length_range.most;
  const std::string_view unit = by_load ? "N" : "m";
  const auto within_reach = [&](const std::string& key, double distance) {
    return judge.require_for(presses ? "path" : "", distance < most, key, quantity(distance, unit),
                             presses ? "would press the bumps flat" : "is unphysical",
                             fmt::format("stay below {} from the centre", quantity(most, unit)));
  };
  for (std::size_t i = 0; i < path.points.values.size(); ++i) {
    if (!within_reach(fmt::format("path.points[{}]", i + 1), path.points.values[i].norm())) return;
  }
  std::int64_t increments = std::ssize(path.points.values);
  if (!path.is_orbit()) {
    judge.require(path.centre.value.isZero(0.0) && path.semi_axes.value.isZero(0.0),
                  path.centre.value.isZero(0.0) ? "path.semi_axes" : "path.centre", "",
                  "belongs to an orbit, but the path goes through points", "remove it, or the points");
  } else {
    const Eigen::Vector2d& axes = path.semi_axes.value;
    judge.require(path.semi_axes.control == path.centre.control, "path.semi_axes", "",
                  by_load ? "are lengths where the centre is a load" : "are forces where the centre is a position",
                  "give both as lengths, or both as forces");
    judge.require(axes.minCoeff() >= 0.0 && axes.maxCoeff() > 0.0, "path.semi_axes",
                  fmt::format("({}, {})", quantity(axes.x(), unit), quantity(axes.y(), unit)),
                  "must not be negative, nor both zero", "give two lengths of an ellipse; one may be zero");
    within_reach("path.centre", path.centre.value.norm() + axes.maxCoeff());
    judge.angle("path.tilt", path.tilt);
    const bool counts =
        judge.require(path.orbits >= 1 && path.orbits <= most_steps, "path.orbits", std::to_string(path.orbits),
                      "is not a valid number of orbits", fmt::format("give a whole number from 1 to {}", most_steps)) &&
        judge.require(path.steps >= 3 && path.steps <= most_steps, "path.steps", std::to_string(path.steps),
                      "is not a valid number of increments",
                      fmt::format("give a whole number from 3 to {}", most_steps));
    if (!counts) return;
    increments = std::int64_t{path.steps} * (path.orbits + 1);
  }
  if (bumps > 0)
    judge_memory(judge, "path", path.is_orbit() ? "path.steps" : "path.points", path.steps, increments, bumps);
}

void judge_combination(Judge& judge, const Case& input) {
  judge.require(input.solver.chosen() == SolverName::newton || input.bump_foil.model != BumpFoilModel::former,
                "solver.name", std::string(name_of(input.solver.chosen())),
                "the former model has no increments of contact to solve", "leave it out");
  judge.require_for("strip", !input.strip || input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
                    std::string(name_of(input.bump_foil.model)),
                    "does not support strips: without gaps and history its loops would have no area",
                    "set model = \"truss\" or \"frame\"");
  judge.require_for("vibration", !input.vibration || input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
                    std::string(name_of(input.bump_foil.model)),
                    "has no history: its loops have no area, and it cannot vibrate about a load",
                    "set model = \"truss\" or \"frame\"");
  judge.require(input.bearing.is_round() || input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
                std::string(name_of(input.bump_foil.model)), "supports round sleeves and journals only",
                "set model = \"truss\" or \"frame\", or remove waves, profiles and taper of [bearing]");
  judge.require_for("montecarlo", !input.montecarlo || input.bump_foil.model != BumpFoilModel::former,
                    "bump_foil.model", std::string(name_of(input.bump_foil.model)),
                    "is not available for ensembles: its loops have no area", "set model = \"truss\" or \"frame\"");
  judge.require_for("montecarlo",
                    !input.montecarlo || input.montecarlo->command != EnsembleCommand::equilibrium || input.equilibrium,
                    "montecarlo.command", std::string(name_of(EnsembleCommand::equilibrium)),
                    "needs the table [equilibrium], which is missing", "add [equilibrium], or set command = \"cycle\"");
  judge.require_for(
      "montecarlo",
      !input.montecarlo || !input.montecarlo->limits || input.montecarlo->command == EnsembleCommand::equilibrium,
      "montecarlo.limits", "true", "are those of running bearings", "set command = \"equilibrium\"");
  const CycleSettings& cycle = input.cycle;
  const bool plain = cycle.amplitude.control == Control::displacement && !cycle.swings() && cycle.cycles == 1;
  judge.require_for(
      "cycle", plain || input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
      std::string(name_of(input.bump_foil.model)), "has no history: it can only be pushed from the centre",
      "set model = \"truss\" or \"frame\", or remove cycle.preload, cycle.load, cycle.swing and cycle.cycles");
  judge.require_for("path", !input.path || input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
                    std::string(name_of(input.bump_foil.model)),
                    "has no history: it can only be pushed from the centre", "set model = \"truss\" or \"frame\"");
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

/// Whether one of these concerns all commands.
bool any_concerns_all(const std::vector<JudgedFault>& faults) {
  return std::any_of(faults.begin(), faults.end(), [](const JudgedFault& one) { return one.command.empty(); });
}

/// Errors of a single pad, other than those of the bearing.
std::vector<JudgedFault> find_faults_of_pad(Case alone, std::size_t pad, double lobe,
                                            const std::vector<JudgedFault>& known) {
  // On a preloaded pad the journal flattens the bumps earlier.
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

/// Foils of pads, first as they are given, then stretched to their arcs.
std::vector<JudgedFault> find_pad_faults(const Case& input, const std::vector<JudgedFault>& known) {
  std::vector<JudgedFault> faults;
  const auto add = [&](const PadDesign& pad, std::size_t k) {
    Case alone = input;
    static_cast<PadDesign&>(alone) = pad;
    alone.pads.clear();
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
  // What commands meet in a pad they meet in the placed one again.
  if (any_concerns_all(faults) || any_concerns_all(known)) return faults;
  faults.clear();
  const std::vector<PlacedPad> pads = place_pads(input);
  for (std::size_t k = 0; k < pads.size(); ++k) add(pads[k].alone, k);
  if (any_concerns_all(faults)) return faults;
  Judge judge;
  judge_overlaps(judge, input);
  std::vector<JudgedFault> overlaps = judge.take();
  faults.insert(faults.end(), overlaps.begin(), overlaps.end());
  return faults;
}

}  // namespace

std::vector<JudgedFault> judge_case(const Case& input) {
  Judge judge;
  const BumpFoil& foil = input.bump_foil;
  const bool radius = judge_bearing(judge, input.bearing, input.strip.has_value());
  const double usable_radius = radius ? input.bearing.radius : 0.0;

  judge_material(judge, "bump_foil", foil);
  const auto [bumps, rise] = judge_bump_foil(judge, foil, usable_radius);
  judge_truss(judge, foil.truss);

  if (foil.model != BumpFoilModel::former) {
    const TopFoil& top = input.top_foil;
    judge_material(judge, "top_foil", top);
    if (judge.within("top_foil.thickness", top.thickness, length_range) && radius) {
      judge_thinness(judge, "top_foil.thickness", top.thickness, usable_radius);
    }
  }
  judge.within("friction.top_bump", input.friction.top_bump, coefficient_range);
  judge.within("friction.bump_sleeve", input.friction.bump_sleeve, coefficient_range);
  judge_solver(judge, input.solver.uzawa);
  judge_cycle(judge, input, bumps, rise);
  if (input.strip) judge_strip(judge, *input.strip, foil, rise);
  if (input.path) judge_path(judge, *input.path, bumps ? total_bumps(input) : 0, flattening(input.bearing, rise));
  if (input.vibration) judge_vibration(judge, *input.vibration, flattening(input.bearing, rise));
  judge_film_settings(judge, input, bumps);
  if (input.montecarlo) judge_montecarlo(judge, *input.montecarlo, usable_radius);
  judge_combination(judge, input);
  const bool placed = judge_pads(judge, input, usable_radius);
  std::vector<JudgedFault> faults = judge.take();
  if (!placed) return faults;
  std::vector<JudgedFault> more = find_pad_faults(input, faults);
  faults.insert(faults.end(), more.begin(), more.end());
  return faults;
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
