#include <utility>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/vibration/vibration_files.hpp"

namespace bumpfoil {

ExperimentInfo vibration_experiment() {
  return {.name = "vibration",
          .summary = "Let the journal vibrate about static loads: stiffness, damping and loss factor",
          .examples =
              "  bumpfoil vibration examples/vibration.toml -o vibration\n"
              "  bumpfoil vibration examples/vibration.toml -o heavy --set "
              "'vibration.loads=[[\"0 N\", \"-200 N\"]]'\n"
              "coefficients.toml holds the arguments of BearingElement of the rotor dynamics program ROSS.\n",
          .files = vibration_file_names(),
          .run = [](const Case& input, const Switches&, const ProgressCallback& progress) {
            VibrationResult result = run_vibration(input, progress);
            const RunStatus status = status_of(result);
            Outcome outcome{.status = status,
                            .table = vibration_table(input, result),
                            .warnings = warning_lines(input, result),
                            .failures = failure_lines(input, result)};
            outcome.files = [input, status, result = std::move(result)](const Provenance& provenance) {
              return vibration_files(input, result, status, provenance);
            };
            return outcome;
          }};
}

}  // namespace bumpfoil
