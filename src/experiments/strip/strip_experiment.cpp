#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "experiments/cycle/cycle_outcome.hpp"

namespace bumpfoil {

ExperimentInfo strip_experiment() {
  const ExperimentRun run = [](const Case& input, const ProgressCallback& progress) {
    return cycle_outcome(input, run_strip(input, progress));
  };
  return {.name = "strip",
          .summary = "Compress a flat strip of the foils between two plates, as specified in [strip]",
          .examples =
              "  bumpfoil strip examples/strip.toml -o strip\n"
              "  bumpfoil strip examples/strip.toml -o pressed --set strip.preload=\"100 N\"\n"
              "  bumpfoil strip examples/strip.toml -o free --set strip.weld=none\n",
          .files = {"summary.json", "strip.csv", "result.nc"},
          .advice = cycle_advice,
          .run = run,
          .sweeping = cycle_sweeping(Experiment::strip, run),
          .quantities = meanings_of(cycle_quantities(Experiment::strip)),
          .small_runs = {{"strip.bumps=3", "strip.displacement=20 um", "strip.steps=2", "solver.name=events",
                          "bump_foil.model=frame"}}};
}

}  // namespace bumpfoil
