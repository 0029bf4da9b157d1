#include "bumpfoil/experiments/equilibrium/running_bearing.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/film/wall_film.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "commands.hpp"
#include "experiment.hpp"

namespace bumpfoil {
namespace {

Outcome outcome_of(const Case& input, EquilibriumResult result, int ross_version = 3) {
  const RunStatus status = status_of(result);
  Outcome outcome{.status = status,
                  .table = equilibrium_table(result),
                  .warnings = warning_lines(input, result),
                  .failures = failure_lines(result),
                  .files = {}};
  outcome.files = [input, status, ross_version, result = std::move(result)](const Provenance& provenance) {
    return equilibrium_files(input, result, status, provenance, ross_version);
  };
  return outcome;
}

struct EquilibriumFlags {
  RunningRequest request;
  int ross_version{3};
};

}  // namespace

void add_equilibrium_command(CLI::App& program, Session& session) {
  const auto flags = std::make_shared<EquilibriumFlags>();
  CLI::App* command = add_experiment(
      program, session,
      {.name = "equilibrium",
       .summary = "Find where the journal of a running bearing is, with gas film, foils and friction",
       .examples = "  bumpfoil equilibrium examples/running.toml -o running\n"
                   "  bumpfoil equilibrium examples/running.toml -o coasting --set equilibrium.path=speed_ramp\n"
                   "Several states may exist at one speed and load, even without friction: the path decides which is "
                   "found.\n"
                   "coefficients.toml holds the arguments of BearingElement of the rotor dynamics program ROSS.\n",
       .files = equilibrium_file_names("equilibrium"),
       .sampled = EnsembleCommand::equilibrium,
       .run = [flags](const Case& input, const ProgressCallback& progress) {
         return outcome_of(input, analyse_running_bearing(input, flags->request, progress), flags->ross_version);
       }});
  command->add_flag("--paths", flags->request.all_paths,
                    "Reach every state by every path that leads there, and report the spread: equilibrium.paths=all");
  command->add_flag("--limits", flags->request.limits,
                    "Find lift-off speeds and load capacities, too, where the film is film.h_lift_off thin");
  command
      ->add_option("--ross-version", flags->ross_version,
                   "Version of ROSS that coefficients.toml is for: 2 has synchronous coefficients alone")
      ->check(CLI::Range(2, 3).description("2 or 3"))
      ->type_name("N")
      ->capture_default_str();
}

void add_film_command(CLI::App& program, Session& session) {
  add_experiment(program, session,
                 {.name = "film",
                  .summary = "Find the gas film over a rigid wall, or one of springs, in place of the foils",
                  .examples = "  bumpfoil film case.toml -o rigid --set 'equilibrium.speeds=[\"45000 rpm\"]' --set "
                              "'equilibrium.positions=[[\"15 um\", \"0 um\"]]'\n"
                              "  bumpfoil film case.toml -o winkler --set film.wall=springs --set "
                              "film.wall_stiffness=\"5 GPa/m\" --set film.closed=true\n"
                              "With positions alone: there is one film for each.\n",
                  .files = equilibrium_file_names("film"),
                  .run = [](const Case& input, const ProgressCallback& progress) {
                    return outcome_of(input, run_wall_films(input, progress));
                  }});
}

}  // namespace bumpfoil
