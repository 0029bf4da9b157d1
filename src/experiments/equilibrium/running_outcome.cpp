#include "experiments/equilibrium/running_outcome.hpp"

#include <memory>
#include <utility>

#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/film_limits.hpp"
#include "bumpfoil/experiments/equilibrium/mesh_error.hpp"
#include "bumpfoil/experiments/equilibrium/running_bearing.hpp"
#include "case/case_json.hpp"
#include "experiments/equilibrium/equilibrium_json.hpp"
#include "experiments/equilibrium/equilibrium_sampling.hpp"
#include "experiments/equilibrium/running_dataset.hpp"

namespace bumpfoil {
namespace {

SweptResult swept_states(const Case& input, const EquilibriumResult& result) {
  const EquilibriumSettings& settings = *input.equilibrium;
  nlohmann::ordered_json lists{{"states", nlohmann::ordered_json::array()}};
  SweptResult swept{.dataset = equilibrium_dataset(settings, result),
                    .parts = {},
                    .rows = state_table(result),
                    .more = {film_coefficient_table(result)},
                    .lists = {}};
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    swept.parts.push_back({name_of_state(result.states[i]), place_of(settings, i)});
    lists["states"].push_back(state_json(*result.bearing, result.states[i]));
  }
  if (result.with_limits) lists["limits"] = nlohmann::ordered_json::array();
  for (const FilmLimit& limit : result.limits) lists["limits"].push_back(limit_json(limit));
  swept.lists = dump_json(lists, -1);
  return swept;
}

/// One path, without comparison with a second one.
Outcome run_swept(const Case& input, const ProgressCallback& progress) {
  EquilibriumResult result = run_equilibrium(input, {}, progress);
  estimate_mesh_errors(input, result);
  if (input.equilibrium->limits) add_film_limits(input, result, progress);
  return running_outcome(input, std::move(result));
}

}  // namespace

Outcome running_outcome(const Case& input, EquilibriumResult result) {
  const auto states = std::make_shared<const EquilibriumResult>(std::move(result));
  const RunStatus status = status_of(*states);
  return {.status = status,
          .warnings = warning_lines(input, *states),
          .failures = failure_lines(*states),
          .table = [=] { return equilibrium_table(*states); },
          .dataset = [=] { return state_dataset(input, *states); },
          .files = [=](const Provenance& provenance) { return equilibrium_files(input, *states, status, provenance); },
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
  with_limits.insert(with_limits.end(), {"equilibrium.limits=true", "film.h_lift_off=15 um"});
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
      .files = equilibrium_file_names("equilibrium"),
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
