#include "experiments/equilibrium/running_outcome.hpp"

#include <utility>

#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/equilibrium/running_bearing.hpp"

namespace bumpfoil {

Outcome running_outcome(const Case& input, EquilibriumResult result, int ross_version) {
  const RunStatus status = status_of(result);
  Outcome outcome{.status = status,
                  .table = equilibrium_table(result),
                  .warnings = warning_lines(input, result),
                  .failures = failure_lines(result)};
  outcome.files = [input, status, ross_version, result = std::move(result)](const Provenance& provenance) {
    return equilibrium_files(input, result, status, provenance, ross_version);
  };
  return outcome;
}

ExperimentInfo equilibrium_experiment() {
  return {
      .name = "equilibrium",
      .summary = "Find where the journal of a running bearing is, with gas film, foils and friction",
      .examples =
          "  bumpfoil equilibrium examples/running.toml -o running\n"
          "  bumpfoil equilibrium examples/running.toml -o coasting --set equilibrium.path=speed_ramp\n"
          "Several states may exist at one speed and load, even without friction: the path decides which is "
          "found.\n"
          "coefficients.toml holds the arguments of BearingElement of the rotor dynamics program ROSS.\n",
      .files = equilibrium_file_names("equilibrium"),
      .switches = {{"paths",
                    "Reach every state by every path that leads there, and report the spread: equilibrium.paths=all"},
                   {"limits", "Find lift-off speeds and load capacities, too, where the film is film.h_lift_off thin"},
                   {"ross-version",
                    "Version of ROSS that coefficients.toml is for: 2 has synchronous coefficients alone",
                    {"3", "2"}}},
      .sampled = EnsembleCommand::equilibrium,
      .run = [](const Case& input, const Switches& switches, const ProgressCallback& progress) {
        const RunningRequest request{.all_paths = switches.contains("paths"), .limits = switches.contains("limits")};
        const auto ross = switches.find("ross-version");
        return running_outcome(input, analyse_running_bearing(input, request, progress),
                               ross != switches.end() && ross->second == "2" ? 2 : 3);
      }};
}

}  // namespace bumpfoil
