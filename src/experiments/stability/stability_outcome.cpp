#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "case/case_json.hpp"
#include "experiments/run_sampling.hpp"
#include "experiments/stability/stability_dataset.hpp"
#include "experiments/stability/stability_json.hpp"
#include "experiments/stability/stability_quantities.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {
namespace {

Outcome stability_outcome(const Case& input, StabilityResult made) {
  const auto result = std::make_shared<const StabilityResult>(std::move(made));
  return {.status = status_of(*result),
          .warnings = warning_lines(input, *result),
          .failures = failure_lines(*result),
          .table = [=] { return stability_table(*result); },
          .dataset = [=] { return stability_dataset(*result); },
          .contents =
              [=](const std::string& /*run_id*/) {
                return ResultContents{.tables = {{"stability.csv", motion_table(*result)}},
                                      .lists = stability_lists(*result)};
              },
          .swept =
              [=](bool /*with_loops*/) {
                return SweptResult{.dataset = stability_dataset(*result, false),
                                   .parts = {{"", 0}},
                                   .rows = motion_table(*result),
                                   .lists = dump_json(stability_lists(*result), -1)};
              }};
}

}  // namespace

ExperimentInfo stability_experiment() {
  const std::vector<std::string> speeds{"stability.speeds=[\"11000 rpm\", \"13000 rpm\"]", "film.columns_per_pitch=4",
                                        "film.rows=4", "rotor.mass=2 kg"};
  const ExperimentRun run = [](const Case& input, const ProgressCallback& progress) {
    return stability_outcome(input, run_stability(input, progress));
  };
  const Sweeping sweeping{
      .run = run, .not_begun = [](const Case& input) { return stability_outcome(input, stability_not_begun(input)); }};
  return {
      .name = "stability",
      .summary = "Find the free motions of rotor, film and foils over speed, and where whirl begins",
      .examples =
          "  bumpfoil stability examples/rotor.toml -o stability\n"
          "  bumpfoil stability examples/rotor.toml -o lighter --set rotor.mass=\"1 kg\"\n"
          "  bumpfoil sweep examples/rotor.toml --command stability --over 'rotor.mass=[1 kg, 2 kg, 4 kg]' -o masses\n"
          "  bumpfoil stability examples/rotor_tolerances.toml --sample rotor_tolerances/ensemble.nc:3 -o three\n"
          "Growth is the real part of a rate over the speed of rotation; 1: the motion grows by a factor e per "
          "radian.\n",
      .files = {"summary.json", "stability.csv", "result.nc"},
      .advice = "use fewer speeds",
      .run = run,
      .sweeping = sweeping,
      .sampling = rotor_sampling("stable_up_to", sweeping),
      .quantities = meanings_of(stability_quantities()),
      .part_quantities = meanings_of(speed_quantities(), motion_quantities()),
      .small_runs = {speeds}};
}

}  // namespace bumpfoil
