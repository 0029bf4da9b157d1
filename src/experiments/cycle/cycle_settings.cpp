#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "case/case_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

void describe(CaseVisitor& keys, CycleSettings& cycle) {
  using enum Presence;
  using enum Dimension;
  if (cycle.directions.empty()) {
    using std::numbers::pi;
    cycle.directions = {0.0, pi, 0.5 * pi, 1.5 * pi};
  }
  keys.directions({"directions", defaulted, "Directions", "of the cycles; also angles, \"37.5 deg\"",
                   "[\"+X\", \"-X\", \"+Y\", \"-Y\"]", angle},
                  cycle.directions);
  keys.one_of(
      {"amplitude", required, "Amplitude", "displacement of the journal", "79.5 um", length},
      {"load", required, "Load", "load on the journal, instead; the journal is free to move sideways", "100 N", force},
      cycle.amplitude);
  keys.either({"preload", optional, "Preload",
               "cycles run about this load (or position, [\"0 um\", \"-40 um\"]), by the amplitude each way",
               "[\"0 N\", \"-50 N\"]"},
              cycle.amplitude.control, cycle.preload);
  keys.value(
      {"swing", defaulted, "Fully reversed", "true: fully reversed, through the centre to the other side and back"},
      &cycle.swing);
  keys.value({"cycles", defaulted, "Cycles", "at most this many, until the loop has settled; results hold the last"},
             &cycle.cycles);
  keys.value({"steps", defaulted, "Increments per branch", "equal increments from the start to full amplitude"},
             &cycle.steps);
  keys.value({"clearance_forces", defaulted, "Clearances at", "forces at which a push test would report contact",
              "[\"5 N\", \"10 N\"]", force},
             &cycle.clearance_forces);
}

void describe_cycle(CaseVisitor& keys, Case& input) {
  using enum Presence;
  settings_table<CycleSettings>(keys, {"cycle", optional, "Cycle", "the journal is pushed and pulled back"},
                                input.settings, describe);
}

/// Repeated directions, including full turns, would only repeat their results.
void check_repetition(Checks& checks, const std::vector<double>& directions) {
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
  std::sort(again.begin(), again.end());  // as written in the case, not by angle
  for (const auto& [second, first] : again) {
    checks.require(false, fmt::format("cycle.directions[{}]", second + 1), quantity(directions[second], "rad"),
                   fmt::format("repeats cycle.directions[{}]", first + 1), "give every direction once");
  }
}

/// Checks the extent of journal cycles from their preload on; `limit`: displacement that flattens the bumps, 0 if
/// unknown.
void check_course(Checks& checks, const CycleSettings& cycle, double limit) {
  const bool by_load = cycle.amplitude.control == Control::load;
  const bool amplitude = by_load ? checks.within("cycle.load", cycle.amplitude.value, load_range)
                                 : checks.within("cycle.amplitude", cycle.amplitude.value, length_range);
  double start = 0.0;
  if (cycle.preload) {
    const auto& [control, value] = *cycle.preload;
    const bool is_load = control == Control::load;
    const std::string_view unit = is_load ? "N" : "m";
    const std::string shown = fmt::format("({}, {})", quantity(value.x(), unit), quantity(value.y(), unit));
    const double most = is_load ? load_range.most : length_range.most;
    if (!checks.require(value.norm() <= most, "cycle.preload", shown, "is unphysical",
                        fmt::format("give at most {}", quantity(most, unit)))) {
      return;
    }
    checks.require(!is_load || value.norm() >= load_range.least, "cycle.preload", shown,
                   "is zero: the journal position would be undetermined",
                   "give a load, or leave it out for cycles from the centre");
    checks.require(is_load || !by_load, "cycle.preload", shown,
                   "is a displacement where the cycles are controlled by load",
                   "give a load, or cycle.amplitude in place of cycle.load");
    if (!is_load) start = value.norm();
    checks.require_for("cycle", is_load || limit <= 0.0 || start < limit, "cycle.preload", shown,
                       "would press the bumps flat",
                       fmt::format("give less than clearance and rise together, {:.6g} m", limit));
  }
  if (by_load || !amplitude || limit <= 0.0 || start >= limit) return;
  const bool flat = start + cycle.amplitude.value >= limit;
  checks.require_for("cycle", !flat, "cycle.amplitude", quantity(cycle.amplitude.value, "m"),
                     start > 0.0 ? "would press the bumps flat on top of cycle.preload" : "would press the bumps flat",
                     fmt::format("give less than clearance and rise together, {:.6g} m{}", limit,
                                 start > 0.0 ? ", preload included" : ""));
}

void check_cycle(Checks& checks, const Case& input, const CheckedBumpFoil& foil) {
  const CycleSettings* const held = input.settings.find<CycleSettings>();
  if (held == nullptr) return;
  const CycleSettings& cycle = *held;
  checks.require(!cycle.directions.empty(), "cycle.directions", "", "no direction specified",
                 "give a list such as [\"+X\", \"90 deg\"]");
  for (std::size_t i = 0; i < cycle.directions.size(); ++i) {
    checks.angle(fmt::format("cycle.directions[{}]", i + 1), cycle.directions[i]);
  }
  check_repetition(checks, cycle.directions);
  check_course(checks, cycle, flattening(input.bearing, foil.rise));
  const bool steps = checks.count("cycle.steps", cycle.steps, "increments");
  checks.count("cycle.cycles", cycle.cycles, "cycles");
  for (std::size_t i = 0; i < cycle.clearance_forces.size(); ++i) {
    checks.within(fmt::format("cycle.clearance_forces[{}]", i + 1), cycle.clearance_forces[i], load_range);
  }
  const bool plain =
      cycle.amplitude.control == Control::displacement && !cycle.is_fully_reversed() && cycle.cycles == 1;
  checks.require_history(
      "cycle", plain || input.bump_foil.model != BumpFoilModel::former,
      "has no history: it can only be pushed from the centre",
      "set model = \"truss\" or \"frame\", or remove cycle.preload, cycle.load, cycle.swing and cycle.cycles");
  if (!foil.bumps || !steps) return;
  const auto increments = std::int64_t{cycle.is_fully_reversed() ? 4 : 2} * cycle.steps * std::ssize(cycle.directions);
  check_memory(checks, "cycle", "cycle.steps", cycle.steps, increments, total_bumps(input));
}

}  // namespace

CaseTable cycle_settings() {
  return {.experiment = "cycle",
          .needs = "cycle",
          .foils = true,
          .describe = describe_cycle,
          .check = check_cycle,
          .given = gives<CycleSettings>,
          .swept = true,
          .sampled_by = SolverName::events};
}

}  // namespace bumpfoil
