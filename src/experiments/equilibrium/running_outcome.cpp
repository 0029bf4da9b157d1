#include "experiments/equilibrium/running_outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_tables.hpp"
#include "bumpfoil/experiments/equilibrium/film_limits.hpp"
#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"
#include "bumpfoil/experiments/equilibrium/running_bearing.hpp"
#include "case/case_json.hpp"
#include "experiments/equilibrium/equilibrium_json.hpp"
#include "experiments/equilibrium/equilibrium_sampling.hpp"
#include "experiments/equilibrium/film_ross_toml.hpp"
#include "experiments/equilibrium/running_dataset.hpp"
#include "results/result_files.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const EquilibriumResult& result, const PathSpread& spread) {
  const BearingModel& bearing = *result.bearing;
  Json json;
  json["states"] = spread.states;
  for (const RunningQuantity& quantity : running_quantities(bearing)) {
    if (quantity.form.kind != Form::real && quantity.name != "loaded_bumps") continue;
    if (quantity.is(tag::requested) && quantity.name == "wall_time") continue;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const std::size_t i : spread.states) {
      const double value = value_of(quantity, bearing, result.states[i]);
      least = std::min(least, value);
      most = std::max(most, value);
    }
    json[quantity.key()] = {{"min", value_json(least, {})}, {"max", value_json(most, {})}};
  }
  return json;
}

Json equilibrium_lists(const EquilibriumResult& result) {
  Json json{{"states", Json::array()}, {"spreads", Json::array()}, {"limits", Json::array()}};
  for (const RunningState& state : result.states) json["states"].push_back(state_json(*result.bearing, state));
  for (const PathSpread& spread : path_spreads(result)) json["spreads"].push_back(spread_json(result, spread));
  for (const FilmLimit& limit : result.limits) json["limits"].push_back(limit_json(limit));
  return json;
}

std::vector<TableFile> tables_of(const EquilibriumResult& result) {
  std::vector<TableFile> tables{{fmt::format("{}.csv", command_of(result)), state_table(result)}};
  if (result.bearing->has_foils()) tables.push_back({"coefficients.csv", film_coefficient_table(result)});
  return tables;
}

std::vector<ResultFile> texts_of(const Case& input, const EquilibriumResult& result, const std::string& run_id) {
  if (!result.bearing->has_foils()) return {};
  return {{"coefficients.toml", film_ross_toml(input, result, run_id)}};
}

/// @param result  checked for rotor dynamics, see StateCheckers: coefficients.toml has no bearing without
ResultContents running_contents(const Case& input, const EquilibriumResult& result, const std::string& run_id) {
  return {.tables = tables_of(result), .texts = texts_of(input, result, run_id), .lists = equilibrium_lists(result)};
}

SweptResult swept_states(const Case& input, const EquilibriumResult& result) {
  const EquilibriumSettings& settings = input.settings.get<EquilibriumSettings>();
  Json lists{{"states", Json::array()}};
  SweptResult swept{.dataset = equilibrium_dataset(settings, result),
                    .parts = {},
                    .rows = state_table(result),
                    .more = {film_coefficient_table(result)},
                    .lists = {}};
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    swept.parts.push_back({name_of_state(result.states[i]), place_of(settings, i)});
    lists["states"].push_back(state_json(*result.bearing, result.states[i]));
  }
  if (result.with_limits) lists["limits"] = Json::array();
  for (const FilmLimit& limit : result.limits) lists["limits"].push_back(limit_json(limit));
  swept.lists = dump_json(lists, -1);
  return swept;
}

/// One path, without comparison with a second one.
Outcome run_swept(const Case& input, const ProgressCallback& progress) {
  EquilibriumResult result = run_equilibrium(input, {}, progress);
  estimate_mesh_errors(input, result);
  if (input.settings.get<EquilibriumSettings>().limits) add_film_limits(input, result, progress);
  return running_outcome(input, std::move(result));
}

}  // namespace

Outcome running_outcome(const Case& input, EquilibriumResult result) {
  const auto states = std::make_shared<const EquilibriumResult>(std::move(result));
  return {.status = status_of(*states),
          .warnings = warning_lines(input, *states),
          .failures = failure_lines(*states),
          .table = [=] { return equilibrium_table(*states); },
          .dataset = [=] { return state_dataset(input, *states); },
          .contents = [=](const std::string& run_id) { return running_contents(input, *states, run_id); },
          .swept = [=](bool /*with_loops*/) { return swept_states(input, *states); }};
}

ExperimentInfo equilibrium_experiment() {
  const std::vector<std::string> one_state{"equilibrium.speeds=[\"45000 rpm\"]",
                                           "equilibrium.loads=[[\"10 N\", \"0 N\"]]",
                                           "equilibrium.paths=one",
                                           "equilibrium.steps=1",
                                           "film.columns_per_pitch=4",
                                           "film.rows=4"};
  std::vector<std::string> seated = one_state;  // others flutter at their free end, and take longer
  seated.emplace_back("top_foil.formed_radius=seated");
  std::vector<std::string> with_limits = seated;
  with_limits.insert(with_limits.end(), {"equilibrium.limits=true", "film.h_lift_off=1 um"});
  std::vector<std::string> of_pads = seated;
  of_pads.insert(of_pads.end(), {"bump_foil.bumps=8", "pad=[{}, {}, {}]"});
  std::vector<std::string> on_peaks = seated;
  on_peaks.insert(on_peaks.end(),
                  {"asperity.sigma=0.3 um", "asperity.friction=0.2", "asperity.pressure_factor=250 MPa"});
  std::vector<std::string> across = seated;
  across.emplace_back("width.modes=3");
  across.emplace_back("width.sheet=true");
  across.emplace_back("width.moment=[0, 0]");
  std::vector<std::string> of_strips = seated;
  of_strips.insert(of_strips.end(), {"bump_foil.strips=2", "top_foil.split=true"});
  return {
      .name = "equilibrium",
      .summary = "Compute equilibria of the running bearing, with gas film, foils and friction",
      .examples =
          "  bumpfoil equilibrium examples/running.toml -o running\n"
          "  bumpfoil equilibrium examples/running.toml -o coasting --set equilibrium.path=speed_ramp\n"
          "Several states may exist at one speed and load, even without friction: the path decides which is "
          "found.\n"
          "coefficients.toml holds the arguments of BearingElement of the rotor dynamics program ROSS.\n",
      .files = {"summary.json", "equilibrium.csv", "coefficients.csv", "coefficients.toml", "result.nc"},
      .advice = running_advice,
      .switches = {{.name = "paths",
                    .help = "Compute every state by every path that leads there, and report the spread",
                    .key = "equilibrium.paths",
                    .value = "all"},
                   {.name = "limits",
                    .help = "Also compute lift-off speeds and load capacities at a film thickness of film.h_lift_off",
                    .key = "equilibrium.limits",
                    .value = "true"},
                   {.name = "ross-version",
                    .help = "Version of ROSS for coefficients.toml; 2 has synchronous coefficients only",
                    .key = "equilibrium.ross_version",
                    .values = {"3", "2"}}},
      .run =
          [](const Case& input, const ProgressCallback& progress) {
            return running_outcome(input, analyse_running_bearing(input, progress));
          },
      .sweeping =
          Sweeping{.run = run_swept,
                   .not_begun = [](const Case& input) { return running_outcome(input, equilibrium_not_begun(input)); },
                   .more_tables = {"coefficients.csv"}},
      .sampling = equilibrium_sampling(),
      .quantities = meanings_of(all_running_quantities()),
      .small_runs = {one_state, with_limits, of_pads, on_peaks, across, of_strips}};
}

}  // namespace bumpfoil
