#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/path/path.hpp"
#include "experiments/cycle/cycle_outcome.hpp"

namespace bumpfoil {

ExperimentInfo path_experiment() {
  return {.name = "path",
          .summary = "Move the journal along a prescribed path: positions, loads, orbits",
          .examples =
              "  bumpfoil path case.toml -o orbit --set 'path.centre=[\"0 um\",\"-45 um\"]' --set "
              "'path.semi_axes=[\"10 um\",\"5 um\"]'\n"
              "  bumpfoil path case.toml -o whirl --set 'path.centre=[\"0 N\",\"-100 N\"]' --set "
              "'path.semi_axes=[\"20 N\",\"20 N\"]'\n"
              "  bumpfoil path case.toml -o measured --set path.file=path.csv\n",
          .files = {"summary.json", "path.csv", "result.nc"},
          .advice = cycle_advice,
          .run = [](const Case& input,
                    const ProgressCallback& progress) { return cycle_outcome(input, run_path(input, progress)); },
          .staged =
              [](const Case& input, const StagedRun& staged, const ProgressCallback& progress) {
                return stream_path(input, staged.provenance, staged.folder,
                                   [&](const RecordSink& sink) { return run_path(input, progress, sink); });
              },
          .quantities = meanings_of(cycle_quantities(Experiment::path)),
          .small_runs = {{"path.points=[[\"0 um\", \"-40 um\"], [\"0 um\", \"-50 um\"]]", "solver.name=events"},
                         {"path.centre=[\"0 um\", \"-45 um\"]", "path.semi_axes=[\"5 um\", \"5 um\"]", "path.steps=4",
                          "path.orbits=1", "top_foil.formed_radius=seated"},
                         {"path.points=[[\"0 um\", \"-40 um\"], [\"0 um\", \"-50 um\"]]", "bump_foil.bumps=8",
                          "pad=[{}, {}, {}]"}}};
}

}  // namespace bumpfoil
