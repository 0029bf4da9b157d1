#include "experiments/cycle/cycle_outcome.hpp"

#include <memory>
#include <utility>

#include "bumpfoil/experiments/cycle/cycle_files.hpp"
#include "bumpfoil/experiments/cycle/cycle_summary.hpp"
#include "bumpfoil/experiments/cycle/cycle_table.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"

namespace bumpfoil {

Outcome cycle_outcome(const Case& input, CycleResult result) {
  const auto cycles = std::make_shared<const CycleResult>(std::move(result));
  const RunStatus status = status_of(*cycles);
  return {.status = status,
          .table = cycle_table(input, *cycles),
          .warnings = warning_lines(input, *cycles),
          .failures = failure_lines(input, *cycles),
          .files = [=](const Provenance& provenance) { return cycle_files(input, *cycles, status, provenance); },
          .cycles = cycles};
}

ExperimentInfo cycle_experiment() {
  return {.name = "cycle",
          .summary = "Push the journal in each direction of [cycle] and pull it back",
          .examples =
              "  bumpfoil cycle case.toml -o results\n"
              "  bumpfoil cycle case.toml -o frictionless --set friction.coefficient=0\n"
              "  bumpfoil cycle case.toml -o fine --set cycle.steps=400 --set 'cycle.directions=[\"+X\"]'\n"
              "  bumpfoil cycle case.toml -o seventeen --sample tolerances/ensemble.nc:17\n",
          .files = cycle_file_names("cycle"),
          .sampled = EnsembleCommand::cycle,
          .run = [](const Case& input, const Switches&, const ProgressCallback& progress) {
            return cycle_outcome(input, run_cycles(input, progress));
          }};
}

}  // namespace bumpfoil
