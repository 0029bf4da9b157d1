#include "experiments/cycle/cycle_outcome.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "bumpfoil/experiments/cycle/cycle_table.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/increment_rows.hpp"
#include "bumpfoil/experiments/cycle/result_names.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"
#include "case/case_json.hpp"
#include "experiments/cycle/cycle_dataset.hpp"
#include "experiments/cycle/cycle_json.hpp"
#include "experiments/cycle/cycle_sampling.hpp"
#include "experiments/cycle/result_layout.hpp"
#include "experiments/run_record.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {
namespace {

SweptResult swept_cycles(const Case& input, const CycleResult& result, RunStatus status, bool with_loops) {
  nlohmann::ordered_json lists{{"cycles", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < result.cycles.size(); ++i) lists["cycles"].push_back(cycle_json(input, result, i));
  SweptResult swept{.dataset = cycle_dataset(input, result, status, with_loops ? Extent::loops : Extent::quantities),
                    .parts = {},
                    .rows = cycle_rows(input, result, status),
                    .lists = dump_json(lists, -1)};
  const ResultLayout layout = make_result_layout(input, result.experiment);
  for (std::size_t i = 0; i < layout.places.size(); ++i) {
    swept.parts.push_back({result.experiment == Experiment::strip
                               ? fmt::format("cycle {}", i + 1)
                               : "direction " + direction_name(input.settings.get<CycleSettings>().directions[i]),
                           layout.places[i]});
  }
  return swept;
}

}  // namespace

Outcome cycle_outcome(const Case& input, CycleResult result) {
  const auto cycles = std::make_shared<const CycleResult>(std::move(result));
  const RunStatus status = status_of(*cycles);
  return {.status = status,
          .warnings = warning_lines(input, *cycles),
          .failures = failure_lines(input, *cycles),
          .table = [=] { return cycle_table(input, *cycles); },
          .dataset = [=] { return cycle_dataset(input, *cycles, status, Extent::everything); },
          .contents =
              [=](const std::string& /*run_id*/) {
                return ResultContents{
                    .tables = {{fmt::format("{}.csv", name_of(cycles->experiment)), increment_rows(*cycles)}},
                    .lists = cycle_lists(input, *cycles)};
              },
          .swept = [=](bool with_loops) { return swept_cycles(input, *cycles, status, with_loops); },
          .cycles = cycles};
}

Outcome stream_path(const Case& input, const Provenance& provenance, ResultFolder& folder,
                    const std::function<CycleResult(const RecordSink&)>& run) {
  std::optional<ResultStream> stream;
  Outcome outcome =
      cycle_outcome(input, run([&](const CycleResult& recorded) {
                      if (!stream) {
                        stream.emplace(StreamedFiles{.netcdf = "result.nc", .csv = "path.csv", .advice = cycle_advice},
                                       cycle_dataset(input, recorded, RunStatus::complete, Extent::recorded), folder);
                      }
                      stream->append();
                    }));
  outcome.contents = {};
  const CycleResult& result = *outcome.cycles;
  stream->finish(record_of(name_of(result.experiment), input, outcome, provenance),
                 cycle_dataset(input, result, outcome.status, Extent::totals), cycle_lists(input, result));
  return outcome;
}

Sweeping cycle_sweeping(Experiment experiment, ExperimentRun run) {
  return {.run = std::move(run),
          .not_begun =
              [experiment](const Case& input) {
                // At least one cycle was requested.
                return cycle_outcome(input,
                                     {.solver = input.solver.chosen(),
                                      .experiment = experiment,
                                      .due = 1,
                                      .over_width = experiment == Experiment::cycle && input.varies_over_the_width(),
                                      .cycles = {}});
              },
          .loop_values =
              [experiment](const Case& input) {
                const ResultLayout layout = make_result_layout(input, experiment);
                return layout.cycles.values.size() * layout.increments;
              }};
}

ExperimentInfo cycle_experiment() {
  const ExperimentRun run = [](const Case& input, const ProgressCallback& progress) {
    return cycle_outcome(input, run_cycles(input, progress));
  };
  return {.name = "cycle",
          .summary = "Push the journal in each direction of [cycle] and pull it back",
          .examples =
              "  bumpfoil cycle case.toml -o results\n"
              "  bumpfoil cycle case.toml -o frictionless --set friction.coefficient=0\n"
              "  bumpfoil cycle case.toml -o fine --set cycle.steps=400 --set 'cycle.directions=[\"+X\"]'\n"
              "  bumpfoil cycle case.toml -o seventeen --sample tolerances/ensemble.nc:17\n",
          .files = {"summary.json", "cycle.csv", "result.nc"},
          .advice = cycle_advice,
          .run = run,
          .sweeping = cycle_sweeping(Experiment::cycle, run),
          .sampling = cycle_sampling(),
          .quantities = meanings_of(cycle_quantities(Experiment::cycle, true)),
          .small_runs = {
              {"cycle.directions=[\"+X\"]", "cycle.steps=2", "solver.name=events"},
              {"cycle.directions=[\"+X\"]", "cycle.steps=2", "bump_foil.shim=[{from=1, to=2, thickness=\"5 um\"}]",
               "top_foil.formed_radius=seated"},
              {"cycle.directions=[\"+X\"]", "cycle.steps=2", "bump_foil.bumps=8", "pad=[{}, {}, {}]"},
              {"cycle.directions=[\"+X\"]", "cycle.steps=2", "width.modes=3", "width.tilt=[\"0.1 mrad\", \"0 mrad\"]"},
              {"cycle.directions=[\"+X\"]", "cycle.steps=2", "width.modes=3", "bump_foil.strips=2",
               "bump_foil.strip=[{}, {height_errors=\"-5 um\"}]"}}};
}

}  // namespace bumpfoil
