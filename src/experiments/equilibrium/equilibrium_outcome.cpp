#include <fmt/format.h>

#include <algorithm>

#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/model/case_names.hpp"

namespace bumpfoil {
namespace {

/// A top foil that moves farther than this per displacement of the journal is all but free: coefficients then hold for
/// motions far below any that a rotor makes.
constexpr double most_foil_response = 100.0;
/// Motions of the foil up to this part of the minimum film thickness are small ones.
constexpr double linear_part = 0.1;

std::string times_text(int count) {
  return count == 1 ? "once" : fmt::format("{} times", count);
}

}  // namespace

std::string_view command_of(const EquilibriumResult& result) {
  return result.bearing->has_foils() ? "equilibrium" : "film";
}

RunStatus status_of(const EquilibriumResult& result) {
  if (result.converged()) return RunStatus::complete;
  const bool interrupted =
      std::any_of(result.states.begin(), result.states.end(),
                  [](const RunningState& state) { return state.report.status == FilmStatus::interrupted; }) ||
      std::any_of(result.limits.begin(), result.limits.end(),
                  [](const FilmLimit& limit) { return limit.status == FilmStatus::interrupted; });
  return interrupted ? RunStatus::interrupted : RunStatus::failed;
}

std::vector<std::string> failure_lines(const EquilibriumResult& result) {
  std::vector<std::string> lines;
  for (const RunningState& state : result.states) {
    if (state.found() || state.report.status == FilmStatus::interrupted) continue;
    lines.push_back(running_failure(*result.bearing, state));
  }
  for (const FilmLimit& limit : result.limits) {
    if (limit.found() || limit.status == FilmStatus::interrupted) continue;
    lines.push_back(fmt::format("{}: {}", name_of_limit(limit), reason_of(limit.status)));
  }
  return lines;
}

std::vector<std::string> warning_lines(const Case& input, const EquilibriumResult& result) {
  std::vector<std::string> lines = input.remarks;
  std::size_t lifted = 0;
  std::string first_lifted;
  for (const RunningState& state : result.states) {
    if (!state.found()) continue;
    if (state.report.jumps > 0) {
      lines.push_back(
          fmt::format("{}: the branch of states ended {} on the path, and the foil jumped to another one; several "
                      "states exist at this point: compare with --paths",
                      name_of_state(state), times_text(state.report.jumps)));
    }
    if (const int bumps = lifted_bumps_at_entry(*result.bearing, state); bumps > 1 && lifted++ == 0) {
      first_lifted = fmt::format("{}: {} bumps", name_of_state(state), bumps);
    }
    if (state.foil_response.value_or(0.0) > most_foil_response) {
      lines.push_back(
          fmt::format("{}: the state is nearly singular: the top foil moves {:.3g} times as far as the journal; "
                      "stiffness and coefficients at low frequencies hold only for motions below {:.2g} nm",
                      name_of_state(state), *state.foil_response,
                      1e9 * linear_part * state.outcome->thinnest.thickness * result.bearing->scales.thickness /
                          *state.foil_response));
    }
    const auto compare = [&](std::string_view foil, std::optional<double> stress, std::optional<double> yield_stress) {
      if (!stress || !yield_stress || *stress <= *yield_stress) return;
      lines.push_back(
          fmt::format("{}: the {} yields: its bending stress reaches {:.4g} MPa, its yield stress is {:.4g} "
                      "MPa",
                      name_of_state(state), foil, 1e-6 * *stress, 1e-6 * *yield_stress));
    };
    compare("top foil", state.top_foil_stress, input.top_foil.yield_stress);
    compare("bump foil", state.bump_foil_stress, input.bump_foil.yield_stress);
  }
  for (const FilmLimit& limit : result.limits) {
    if (!limit.found() || limit.jumps == 0) continue;
    lines.push_back(fmt::format("{}: the branch of states ended {} on the path, and the foil jumped to another one",
                                name_of_limit(limit), times_text(limit.jumps)));
  }
  for (const OtherBranch& other : result.other_branches) {
    const RunningState& state = result.states[other.state];
    lines.push_back(fmt::format(
        "{}: {} ends in another state, with a minimum film thickness of {:.4g} um instead of {:.4g} um: the history of "
        "the bearing decides which one it runs in; compare all paths with --paths",
        name_of_state(state), name_of(other.path), 1e6 * other.minimum_film_thickness,
        1e6 * state.outcome->thinnest.thickness * result.bearing->scales.thickness));
  }
  // One line for all: on most paths it is all states or none.
  if (lifted > 0) {
    lines.push_back(
        fmt::format("in {} of {} states the foil is detached at the inlet ({}); the extent may depend on the path: "
                    "compare with --paths",
                    lifted, result.states.size(), first_lifted));
  }
  return lines;
}

}  // namespace bumpfoil
