#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/transient/transient.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/case_json.hpp"
#include "core/collect_errors.hpp"
#include "experiments/run_record.hpp"
#include "experiments/run_sampling.hpp"
#include "experiments/transient/transient_checkpoint.hpp"
#include "experiments/transient/transient_quantities.hpp"
#include "results/result_files.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

RunStatus status_of(const TransientReading& reading) {
  return run_status({reading.result.status}, 1);
}

/// Entries of summary.json: totals of the run, and rubs.
Json transient_lists(const TransientReading& reading) {
  // The common header has a status of its own, that of the run.
  Json json{{"end_status", name_of(reading.result.status)}, {"revolutions", reading.turns.size()}};
  json.update(rows_json(table_of(run_dataset(reading), {.columns = names_of(run_quantities().subspan(1))})).front());
  const WorkBalance& sum = reading.energy.sum;
  json["energy"] = {
      {"entrained_J", sum.entrained}, {"supplied_J", sum.supplied},     {"forces_J", sum.forces},
      {"rubbing_J", sum.rubbing},     {"dissipated_J", sum.dissipated}, {"friction_J", sum.friction},
      {"damping_J", sum.damping},     {"stored_J", sum.stored},         {"defect_J", reading.energy.defect}};
  json["rubs"] = Json::array();
  for (const RubEvent& rub : reading.rubs) {
    json["rubs"].push_back(
        {{"bearing", rub.bearing + 1}, {"begin_s", rub.begin}, {"end_s", rub.end}, {"asperity_load_N", rub.load}});
  }
  return json;
}

constexpr std::string_view advice = "use fewer steps";

Json all_lists(const TransientReading& reading) {
  Json json{{"stations", each(reading.result.machine.places(), [](const RotorStation& place) { return place.name; })}};
  json.update(transient_lists(reading));
  return json;
}

using SharedReading = std::shared_ptr<const TransientReading>;

Outcome transient_outcome(const Case& input, const SharedReading& reading) {
  return {.status = status_of(*reading),
          .warnings = warning_lines(input, *reading),
          .failures = failure_lines(*reading),
          .table = [=] { return transient_table(*reading); },
          .dataset = [=] { return transient_dataset(*reading); },
          .contents =
              [=](const std::string& /*run_id*/) {
                return ResultContents{.tables = {{"transient.csv", revolution_table(*reading)}},
                                      .lists = all_lists(*reading)};
              },
          .swept =
              [=](bool /*with_loops*/) {
                return SweptResult{.dataset = swept_dataset(*reading),
                                   .parts = {{"", 0}},
                                   .rows = table_of(run_dataset(*reading), {.columns = names_of(run_quantities())}),
                                   .lists = dump_json(transient_lists(*reading), -1)};
              }};
}

SharedReading reading_of(TransientResult result) {
  return std::make_shared<const TransientReading>(std::move(result));
}

/// Steps stay on disk, in files from which the run can be resumed.
Outcome stage_transient(const Case& input, const StagedRun& staged, const ProgressCallback& progress) {
  TransientResult begun = transient_not_begun(input);
  KeptRun kept = keep_run(staged.folder.path(), staged.resumes, input, begun.layout.width());
  kept.run.progress = progress;
  const SharedReading reading = reading_of(run_transient(input, std::move(begun), kept.table, kept.run));
  Outcome outcome = transient_outcome(input, reading);
  const ResultContents contents = outcome.contents("");
  stage_result_files(record_of("transient", input, outcome, staged.provenance), "result.nc", advice, outcome.dataset(),
                     contents.lists, staged.folder, contents.tables);
  outcome.contents = {};
  return outcome;
}

/// Checks places of pulses, which require the rotor.
std::vector<InputError> transient_errors(const Case& input) {
  if (!find_errors(input).empty()) return {};  // the rotor requires valid bearings
  std::vector<InputError> errors;
  collect_errors(errors, [&] { static_cast<void>(transient_not_begun(input)); });
  return errors;
}

}  // namespace

ExperimentInfo transient_experiment() {
  const std::vector<std::string> small{"transient.speed={to=\"12000 rpm\", time=\"11 ms\"}",
                                       "transient.steps_per_revolution=20",
                                       "transient.revolutions_per_spectrum=1",
                                       "film.columns_per_pitch=4",
                                       "film.rows=4",
                                       "rotor.mass=2 kg",
                                       "rotor.unbalance=[{amount=\"2 g mm\"}]"};
  const ExperimentRun run = [](const Case& input, const ProgressCallback& progress) {
    return transient_outcome(input, reading_of(run_transient(input, progress)));
  };
  const Sweeping sweeping{.run = run, .not_begun = [](const Case& input) {
                            return transient_outcome(input, reading_of(transient_not_begun(input)));
                          }};
  return {.name = "transient",
          .summary = "March a rotor on its bearings in time: run-up, coast-down, impulses, base motion",
          .examples =
              "  bumpfoil transient examples/coast_down.toml -o coast_down\n"
              "  bumpfoil transient examples/rotor.toml -o whirl --set 'transient.speed={to=\"16000 rpm\", "
              "time=\"0.1 s\"}' --set 'transient.pulse={force=[\"0 N\", \"20 N\"], begin=\"5 ms\", duration=\"1 "
              "ms\"}'\n",
          .files = {"summary.json", "transient.csv", "result.nc"},
          .advice = advice,
          .run = run,
          .check = transient_errors,
          .staged = stage_transient,
          .checkpoints = transient_checkpoint_names(),
          .sweeping = sweeping,
          .sampling = rotor_sampling("largest_half_peak_to_peak", sweeping),
          .quantities = meanings_of(run_quantities()),
          .part_quantities = meanings_of(whole_turn_quantities(), turn_quantities()),
          .small_runs = {small}};
}

}  // namespace bumpfoil
