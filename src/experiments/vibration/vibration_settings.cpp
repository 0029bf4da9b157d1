#include <cmath>
#include <cstdint>
#include <string>

#include "bumpfoil/experiments/vibration/vibration_settings.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "case/case_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

void describe(CaseVisitor& keys, VibrationSettings& vibration) {
  using enum Presence;
  using enum Dimension;
  keys.vectors(
      {"loads", required, "Loads", "static loads on the journal, along X and Y; each from the unstressed foils",
       "[[\"0 N\", \"-50 N\"]]", force},
      vibration.loads);
  keys.choice({"motion", defaulted, "Motion", "along the directions; \"orbit\": circles, once in either sense"},
              vibration.motion);
  keys.directions({"directions", vibration.orbits() ? optional : required, "Directions",
                   "of the vibrations: one, or two at right angles", "[\"+X\", \"+Y\"]", angle},
                  vibration.directions);
  keys.value({"amplitudes", required, "Amplitudes",
              "displacement of the journal to each side, without sideways motion; the radius of an orbit",
              "[\"1 um\", \"2 um\", \"5 um\"]", length},
             &vibration.amplitudes);
  keys.value({"frequencies", required, "Frequencies",
              "at which damping coefficients are computed; the loops do not depend on them. Also \"12000 rpm\"",
              "[\"200 Hz\"]", frequency},
             &vibration.frequencies);
  keys.value({"steps", defaulted, "Increments per amplitude",
              "equal increments up to a load, and from the middle to a turning point"},
             &vibration.steps);
}

void describe_vibration(CaseVisitor& keys, Case& input) {
  using enum Presence;
  settings_table<VibrationSettings>(
      keys,
      {"vibration", optional, "Vibration",
       "the journal vibrates about static loads, for the command vibration: each load in each direction with each "
       "amplitude"},
      input.settings, describe);
}

/// Maximum number of loop points, kept until the end, and of coefficient rows.
constexpr std::int64_t most_loop_points = 20'000'000;
constexpr std::int64_t most_rows = 1'000'000;

/// @param example  of an entry
bool check_presence(Checks& checks, const std::string& key, std::size_t size, std::string_view example) {
  return checks.require(size > 0, key, "[]", "is empty", fmt::format("give at least one: [{}]", example));
}

void check_directions(Checks& checks, const VibrationSettings& vibration) {
  const std::vector<double>& directions = vibration.directions;
  if (vibration.orbits()) {
    checks.require(directions.empty(), "vibration.directions", fmt::format("{} directions", directions.size()),
                   "belong to a motion along lines", "remove them, or set motion = \"line\"");
    return;
  }
  if (!check_presence(checks, "vibration.directions", directions.size(), "\"+X\"")) return;
  bool finite = true;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    finite = checks.angle(fmt::format("vibration.directions[{}]", i + 1), directions[i]) && finite;
  }
  if (!finite || directions.size() == 1) return;
  const double across = unit_vector(directions[0]).dot(unit_vector(directions[1]));
  checks.require(directions.size() == 2 && std::abs(across) <= round_off, "vibration.directions",
                 fmt::format("{} directions", directions.size()), "are not two at right angles",
                 "give one, or two such as [\"+X\", \"+Y\"]: these give all coefficients");
}

void check_size(Checks& checks, const VibrationSettings& vibration) {
  const auto vibrations =
      std::ssize(vibration.loads) * static_cast<std::int64_t>(vibration.motions()) * std::ssize(vibration.amplitudes);
  checks.require_for("vibration", vibrations <= most_loop_points / (4 * std::int64_t{vibration.steps}),
                     "vibration.steps", std::to_string(vibration.steps),
                     fmt::format("the loops of {} vibrations would not fit in memory", vibrations),
                     "give fewer steps, loads or amplitudes");
  const auto rows = std::ssize(vibration.loads) * std::ssize(vibration.amplitudes) * std::ssize(vibration.frequencies);
  checks.require_for("vibration", rows <= most_rows, "vibration.frequencies",
                     fmt::format("{} frequencies", vibration.frequencies.size()),
                     fmt::format("make {} rows of coefficients", rows), fmt::format("give less than {}", most_rows));
}

void check_vibration(Checks& checks, const Case& input, const CheckedBumpFoil& foil) {
  const VibrationSettings* const held = input.settings.find<VibrationSettings>();
  if (held == nullptr) return;
  const VibrationSettings& vibration = *held;
  const double limit = flattening(input.bearing, foil.rise);
  checks.require_history("vibration", input.bump_foil.model != BumpFoilModel::former,
                         "has no history: its loops have no area, and it cannot vibrate about a load");
  check_presence(checks, "vibration.loads", vibration.loads.size(), "[\"0 N\", \"-50 N\"]");
  for (std::size_t i = 0; i < vibration.loads.size(); ++i) {
    const double load = vibration.loads[i].norm();
    const std::string key = fmt::format("vibration.loads[{}]", i + 1);
    const bool any = checks.require(load != 0.0, key, "(0 N, 0 N)",
                                    "is zero: the journal position would be undetermined", "give a load");
    if (any) checks.within(key, load, load_range);
  }
  check_directions(checks, vibration);
  check_presence(checks, "vibration.amplitudes", vibration.amplitudes.size(), "\"2 um\"");
  for (std::size_t i = 0; i < vibration.amplitudes.size(); ++i) {
    const std::string key = fmt::format("vibration.amplitudes[{}]", i + 1);
    const double amplitude = vibration.amplitudes[i];
    if (!checks.within(key, amplitude, length_range) || limit <= 0.0) continue;
    checks.require_for("vibration", amplitude < limit, key, quantity(amplitude, "m"), "would press the bumps flat",
                       fmt::format("give less than clearance and rise together, {:.6g} m", limit));
  }
  check_presence(checks, "vibration.frequencies", vibration.frequencies.size(), "\"200 Hz\"");
  for (std::size_t i = 0; i < vibration.frequencies.size(); ++i) {
    checks.within(fmt::format("vibration.frequencies[{}]", i + 1), vibration.frequencies[i], frequency_range);
  }
  if (checks.count("vibration.steps", vibration.steps, "increments")) check_size(checks, vibration);
}

}  // namespace

CaseTable vibration_settings() {
  return {.experiment = "vibration",
          .needs = "vibration",
          .foils = true,
          .describe = describe_vibration,
          .check = check_vibration,
          .given = gives<VibrationSettings>,
          .swept = true};
}

}  // namespace bumpfoil
