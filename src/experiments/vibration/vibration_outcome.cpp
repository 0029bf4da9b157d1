#include "experiments/vibration/vibration_outcome.hpp"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bumpfoil/experiments/vibration/vibration_table.hpp"
#include "case/case_json.hpp"
#include "experiments/vibration/ross_toml.hpp"
#include "experiments/vibration/vibration_dataset.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
#include "experiments/vibration/vibration_summary.hpp"
#include "experiments/vibration/vibration_tables.hpp"
#include "results/result_files.hpp"

namespace bumpfoil {
namespace {

/// A result in which nothing has been started.
VibrationResult not_begun(const Case& input) {
  const VibrationSettings& settings = input.settings.get<VibrationSettings>();
  VibrationResult result;
  for (const Eigen::Vector2d& load : settings.loads) {
    result.loads.push_back({.load = load, .status = Status::interrupted, .position = {0.0, 0.0}, .tangents = {}});
  }
  result.vibrations.resize(settings.loads.size() * settings.motions() * settings.amplitudes.size());
  for (Vibration& vibration : result.vibrations) vibration.cycle.status = Status::interrupted;
  return result;
}

SweptResult swept_vibrations(const Case& input, const VibrationResult& result, bool with_loops) {
  const VibrationSettings& settings = input.settings.get<VibrationSettings>();
  const std::vector<LinearFoils> all = linear_foils(settings, result);
  const Dataset totals = vibration_dataset(input, result, all, false);
  SweptResult swept{.dataset = vibration_dataset(input, result, all, with_loops),
                    .parts = {},
                    .rows = loop_table(totals, settings),
                    .lists = dump_json(vibration_lists(input, result, totals), -1)};
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    swept.parts.push_back({name_of_vibration(settings, i), i});
  }
  return swept;
}

ResultContents vibration_contents(const Case& input, const VibrationResult& result, const std::string& run_id) {
  const VibrationSettings& settings = input.settings.get<VibrationSettings>();
  const std::vector<LinearFoils> all = linear_foils(settings, result);
  const Dataset totals = vibration_dataset(input, result, all, false);
  return {.tables = {{"vibration.csv", loop_table(totals, settings)}, {"coefficients.csv", coefficient_table(totals)}},
          .texts = {{"coefficients.toml", ross_toml(settings, all, run_id)}},
          .lists = vibration_lists(input, result, totals)};
}

}  // namespace

Outcome vibration_outcome(const Case& input, VibrationResult result) {
  const auto vibrations = std::make_shared<const VibrationResult>(std::move(result));
  return {.status = status_of(*vibrations),
          .warnings = warning_lines(input, *vibrations),
          .failures = failure_lines(input, *vibrations),
          .table = [=] { return vibration_table(input, *vibrations); },
          .dataset =
              [=] {
                return vibration_dataset(input, *vibrations,
                                         linear_foils(input.settings.get<VibrationSettings>(), *vibrations));
              },
          .contents = [=](const std::string& run_id) { return vibration_contents(input, *vibrations, run_id); },
          .swept = [=](bool with_loops) { return swept_vibrations(input, *vibrations, with_loops); }};
}

ExperimentInfo vibration_experiment() {
  const std::vector<std::string> lines{"vibration.loads=[[\"0 N\", \"-50 N\"]]",
                                       "vibration.directions=[\"+X\", \"+Y\"]", "vibration.amplitudes=[\"1 um\"]",
                                       "vibration.frequencies=[\"200 Hz\"]", "vibration.steps=2"};
  std::vector<std::string> of_pads = lines;
  of_pads.insert(of_pads.end(), {"bump_foil.bumps=8", "pad=[{}, {}, {}]"});
  std::vector<std::string> orbits = lines;
  orbits[1] = "vibration.motion=orbit";
  const ExperimentRun run = [](const Case& input, const ProgressCallback& progress) {
    return vibration_outcome(input, run_vibration(input, progress));
  };
  return {
      .name = "vibration",
      .summary = "Vibrate the journal about static loads: stiffness, damping and loss factor",
      .examples =
          "  bumpfoil vibration examples/vibration.toml -o vibration\n"
          "  bumpfoil vibration examples/vibration.toml -o heavy --set "
          "'vibration.loads=[[\"0 N\", \"-200 N\"]]'\n"
          "coefficients.toml holds the arguments of BearingElement of the rotor dynamics program ROSS.\n",
      .files = {"summary.json", "vibration.csv", "coefficients.csv", "coefficients.toml", "result.nc"},
      .advice = "use fewer steps, loads or amplitudes",
      .run = run,
      .sweeping = Sweeping{.run = run,
                           .not_begun = [](const Case& input) { return vibration_outcome(input, not_begun(input)); },
                           .loop_values =
                               [](const Case& input) {
                                 const VibrationSettings& settings = input.settings.get<VibrationSettings>();
                                 // The event-following solver has additional points.
                                 return settings.loads.size() * settings.motions() * settings.amplitudes.size() * 4 *
                                        static_cast<std::size_t>(settings.steps);
                               }},
      .quantities = meanings_of(vibration_quantities()),
      .small_runs = {lines, orbits, of_pads}};
}

}  // namespace bumpfoil
