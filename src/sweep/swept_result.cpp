#include "sweep/swept_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/vibration/vibration_files.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "experiments/cycle/cycle_grid.hpp"
#include "experiments/cycle/cycle_json.hpp"
#include "experiments/cycle/result_layout.hpp"
#include "experiments/equilibrium/equilibrium_grid.hpp"
#include "experiments/equilibrium/equilibrium_json.hpp"
#include "experiments/vibration/vibration_csv.hpp"
#include "experiments/vibration/vibration_grid.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
#include "experiments/vibration/vibration_summary.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {

SweptResult swept_result(const Case& input, const CycleResult& result, RunStatus status, bool with_loops) {
  SweptResult swept{.status = status,
                    .grid = cycle_grid(input, result, status, with_loops),
                    .parts = {},
                    .rows = cycle_rows(input, result, status),
                    .lists = {{"cycles", nlohmann::ordered_json::array()}},
                    .failures = failure_lines(input, result),
                    .warnings = warning_lines(input, result)};
  const ResultLayout layout = make_result_layout(input, result.experiment);
  for (std::size_t cycle = 0; cycle < layout.places.size(); ++cycle) {
    const std::string name = result.experiment == Experiment::strip
                                 ? fmt::format("cycle {}", cycle + 1)
                                 : "direction " + direction_name(input.cycle.directions[cycle]);
    swept.parts.push_back({name, layout.places[cycle]});
  }
  for (std::size_t cycle = 0; cycle < result.cycles.size(); ++cycle) {
    swept.lists["cycles"].push_back(cycle_json(input, result, cycle));
  }
  return swept;
}

SweptResult swept_result(const Case& input, const VibrationResult& result, bool with_loops) {
  const VibrationSettings& settings = *input.vibration;
  const std::vector<LinearFoils> all = linear_foils(settings, result);
  SweptResult swept{.status = status_of(result),
                    .grid = vibration_grid(input, result, all, with_loops),
                    .parts = {},
                    .rows = vibration_csv(settings, result),
                    .lists = vibration_lists(input, result, all),
                    .failures = failure_lines(settings, result),
                    .warnings = warning_lines(input, result)};
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    swept.parts.push_back({name_of_vibration(settings, i), i});
  }
  return swept;
}

SweptResult swept_result(const Case& input, const EquilibriumResult& result) {
  const EquilibriumSettings& settings = *input.equilibrium;
  SweptResult swept{.status = status_of(result),
                    .grid = equilibrium_grid(settings, result),
                    .parts = {},
                    .rows = equilibrium_csv(result),
                    .coefficients = film_coefficients_csv(result),
                    .lists = {{"states", nlohmann::ordered_json::array()}},
                    .failures = failure_lines(result),
                    .warnings = warning_lines(input, result)};
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    swept.parts.push_back({name_of_state(result.states[i]), place_of(settings, i)});
    swept.lists["states"].push_back(state_json(*result.bearing, result.states[i]));
  }
  if (!result.limits.empty()) swept.lists["limits"] = nlohmann::ordered_json::array();
  for (const FilmLimit& limit : result.limits) swept.lists["limits"].push_back(limit_json(limit));
  return swept;
}

std::size_t loop_values(SweptCommand command, const Case& input) {
  if (command == SweptCommand::equilibrium) return 0;
  if (command == SweptCommand::vibration) {
    const VibrationSettings& settings = *input.vibration;
    // The solver that follows events has some more.
    return settings.loads.size() * settings.motions() * settings.amplitudes.size() * 4 *
           static_cast<std::size_t>(settings.steps);
  }
  const ResultLayout layout = make_result_layout(input, experiment_of(command));
  return layout.cycles.values.size() * layout.increments;
}

SweptResult not_begun(const Sweep& sweep, Case input, bool for_all) {
  switch (sweep.command) {
    case SweptCommand::cycle:
    case SweptCommand::strip: {
      CycleResult result;
      result.solver = input.solver.chosen();
      result.experiment = experiment_of(sweep.command);
      return swept_result(input, result, RunStatus::interrupted, sweep.with_loops);
    }
    case SweptCommand::vibration:
      return swept_result(input, vibrations_not_begun(*input.vibration), sweep.with_loops);
    case SweptCommand::equilibrium:
      break;
  }
  EquilibriumResult result = equilibrium_not_begun(input);
  const bool sweeps_speeds =
      std::any_of(sweep.axes.begin(), sweep.axes.end(), [](const SweepAxis& axis) { return axis.is_list; });
  if (for_all && sweeps_speeds) {
    input.equilibrium->speeds = {absent};
    for (RunningState& state : result.states) state.asked.speed = absent;
  }
  result.limits.resize(sweep.with_limits ? 1 : 0);
  SweptResult swept = swept_result(input, result);
  if (sweep.with_limits) swept.lists["limits"] = nlohmann::ordered_json::array();
  return swept;
}

}  // namespace bumpfoil
