#include <algorithm>

#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "case/case_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

void describe(CaseVisitor& keys, EquilibriumSettings& equilibrium) {
  using enum Presence;
  using enum Dimension;
  keys.value({"speeds", required, "Speeds", "of the journal; positive turns X to Y", "[\"45000 rpm\"]", frequency},
             &equilibrium.speeds);
  keys.vectors({"loads", optional, "Loads", "on the journal, along X and Y", "[[\"50 N\", \"0 N\"]]", force},
               equilibrium.loads);
  keys.vectors({.name = "positions",
                .presence = optional,
                .title = "Positions",
                .text = "of the journal, along X and Y, instead of loads",
                .example = "[[\"25 um\", \"0 um\"]]",
                .dimension = length,
                .instead = true},
               equilibrium.positions);
  // Positions have no load for a ramp.
  if (!equilibrium.positions.empty() && equilibrium.path == FilmPath::load_ramp) {
    equilibrium.path = FilmPath::position_ray;
  }
  keys.choice({"path", defaulted, "Path",
               "how states are reached: load after load; \"position_ray\", default with positions; \"speed_ramp\"; "
               "\"cold_start\": each from ambient pressure"},
              equilibrium.path);
  keys.choice({"paths", defaulted, "Paths",
               "number of paths: \"two\" compares the states with those of a second path and reports where they "
               "differ; \"one\" does not; \"all\" keeps the states of every path. Sweeps and ensembles use one"},
              equilibrium.paths);
  keys.value(
      {"prefer_stable", defaulted, "Prefer stable states",
       "true: where a state is unstable with the journal held, look for a stable one by the other paths from rest"},
      &equilibrium.prefer_stable);
  keys.value({"steps", defaulted, "Steps", "equal increments of the ramp to the first state of a path"},
             &equilibrium.steps);
  keys.value({"frequencies", optional, "Frequencies",
              "of small motions about the states, for stiffness and damping; default: that of the rotation",
              "[\"375 Hz\", \"750 Hz\"]", frequency},
             &equilibrium.frequencies);
  keys.value({"limits", defaulted, "Limits",
              "true: also find lift-off speeds and load capacities: of the last stable states with a film thickness of "
              "at least film.h_lift_off"},
             &equilibrium.limits);
  keys.value({"ross_version", defaulted, "Version of ROSS",
              "for which coefficients.toml is written; 2 has synchronous coefficients only"},
             &equilibrium.ross_version);
}

void describe_equilibrium(CaseVisitor& keys, Case& input) {
  using enum Presence;
  settings_table<EquilibriumSettings>(
      keys,
      {"equilibrium", optional, "Equilibrium",
       "the running bearing, for the command equilibrium: all speeds with all loads, or with all positions"},
      input.settings, describe);
}

constexpr double most_speed = 1e6;  // rad/s
/// Limit of mesh nodes of all states together: films are kept until all are written, about 40 bytes per node.
constexpr double most_state_nodes = 1e8;

void check_memory(Checks& checks, const Case& input, const EquilibriumSettings& equilibrium) {
  const std::size_t states =
      equilibrium.speeds.size() * std::max(equilibrium.loads.size(), equilibrium.positions.size());
  const double nodes = static_cast<double>(states) * film_bumps(input) * input.film.columns_per_pitch * input.film.rows;
  const auto runs_states = [](const CaseTable& table) { return table.needs == "equilibrium"; };
  checks.require_for(experiments_where(runs_states), nodes <= most_state_nodes, "equilibrium.speeds",
                     fmt::format("{} states", states), "would not fit in memory with their films",
                     "give fewer speeds or loads, or a coarser film");
}

/// Checks a list of pairs, each entry within +-`most`.
void check_vectors(Checks& checks, const std::string& key, const std::vector<Eigen::Vector2d>& vectors, double most,
                   std::string_view unit) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (const int axis : {0, 1}) {
      const double value = vectors[i][axis];
      const std::string entry = fmt::format("{}[{}][{}]", key, i + 1, axis + 1);
      if (!checks.finite(entry, value, unit)) continue;
      checks.require(std::abs(value) <= most, entry, quantity(value, unit), "is unphysical",
                     fmt::format("give at most {} either way; is the unit right?", quantity(most, unit)));
    }
  }
}

void check_equilibrium(Checks& checks, const Case& input, const CheckedBumpFoil& foil) {
  const EquilibriumSettings* const held = input.settings.find<EquilibriumSettings>();
  checks.require_for("limits", input.film.h_lift_off.has_value(), "film.h_lift_off", "",
                     "is missing: the minimum film thickness at lift-off",
                     "give a thickness such as \"2 um\", three times the roughness of both surfaces together");
  checks.require_for("limits", held != nullptr && !held->loads.empty(), "equilibrium.loads", "", "no load specified",
                     "give a list such as [[\"50 N\", \"0 N\"]]");
  checks.require_for("montecarlo",
                     !input.montecarlo || !input.montecarlo->limits || input.montecarlo->command == "equilibrium",
                     "montecarlo.limits", "true", "are those of running bearings", "set command = \"equilibrium\"");
  if (held == nullptr) return;
  const EquilibriumSettings& equilibrium = *held;
  checks.require(!equilibrium.speeds.empty(), "equilibrium.speeds", "", "no speed specified",
                 "give a list such as [\"45000 rpm\"]");
  for (std::size_t i = 0; i < equilibrium.speeds.size(); ++i) {
    const double speed = equilibrium.speeds[i];
    const std::string entry = fmt::format("equilibrium.speeds[{}]", i + 1);
    if (!checks.finite(entry, speed, "rad/s")) continue;
    checks.require(speed != 0.0 || input.asperity, entry, quantity(speed, "rad/s"), "a journal at rest has no film",
                   "give a speed that is not zero, or add [asperity], which carries a load at rest");
    checks.require_for("limits", speed != 0.0, entry, quantity(speed, "rad/s"),
                       "has neither a lift-off speed nor a load capacity", "find limits from speeds that are not zero");
    checks.require(std::abs(speed) <= most_speed, entry, quantity(speed, "rad/s"), "is unphysical",
                   fmt::format("give at most {} rad/s either way; is the unit right?", most_speed));
  }
  const bool by_load = !equilibrium.loads.empty();
  checks.require_for("equilibrium", by_load || !equilibrium.positions.empty(), "equilibrium.loads", "",
                     "no load specified", "give a list such as [[\"50 N\", \"0 N\"]], or positions");
  checks.require(!by_load || equilibrium.positions.empty(), "equilibrium.positions", "",
                 "conflicts with equilibrium.loads, which is also given", "give one of the two");
  checks.require(by_load || equilibrium.positions.empty() || equilibrium.path != FilmPath::load_ramp,
                 "equilibrium.path", std::string(name_of(equilibrium.path)), "needs loads, but there are positions",
                 "write path = \"position_ray\", \"speed_ramp\" or \"cold_start\"");
  check_vectors(checks, "equilibrium.loads", equilibrium.loads, load_range.most, "N");
  check_vectors(checks, "equilibrium.positions", equilibrium.positions, thin * input.bearing.radius, "m");
  for (std::size_t i = 0; i < equilibrium.loads.size(); ++i) {
    checks.require(!equilibrium.loads[i].isZero(0.0), fmt::format("equilibrium.loads[{}]", i + 1), "0 N",
                   "is zero, so the path to it has no direction", "give a load that is not zero, however small");
  }
  checks.count("equilibrium.steps", equilibrium.steps, "increments");
  if (foil.bumps) check_memory(checks, input, equilibrium);
  checks.require(equilibrium.ross_version == 2 || equilibrium.ross_version == 3, "equilibrium.ross_version",
                 std::to_string(equilibrium.ross_version), "is not a supported version", "give 2 or 3");
  for (std::size_t i = 0; i < equilibrium.frequencies.size(); ++i) {
    checks.within(fmt::format("equilibrium.frequencies[{}]", i + 1), equilibrium.frequencies[i], frequency_range);
  }
}

}  // namespace

CaseTable equilibrium_settings() {
  return {.experiment = "equilibrium",
          .needs = "equilibrium",
          .foils = true,
          .film = true,
          .describe = describe_equilibrium,
          .check = check_equilibrium,
          .given = gives<EquilibriumSettings>,
          .requested_part = [](const Case& input) -> std::string_view {
            const EquilibriumSettings* const held = input.settings.find<EquilibriumSettings>();
            return held != nullptr && held->limits ? "limits" : "";
          },
          .swept = true,
          .sampled_by = SolverName::newton};
}

}  // namespace bumpfoil
