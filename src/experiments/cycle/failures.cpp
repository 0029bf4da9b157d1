#include "bumpfoil/experiments/cycle/failures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"

namespace bumpfoil {
namespace {

/// Whether a cycle includes the way to the preload: the first of a strip, and all of a bearing.
bool begins_with_preload(const Case& input, const CycleResult& result, std::size_t cycle) {
  if (result.experiment == Experiment::strip) {
    return cycle == 0 && input.settings.get<StripSettings>().preload.has_value();
  }
  return result.experiment == Experiment::cycle && input.settings.get<CycleSettings>().preload.has_value() &&
         result.cycles[cycle].loop_energies.empty();
}

}  // namespace

std::string direction_name(double direction) {
  const double degrees = to_degrees(direction);
  constexpr std::array axes{"+X", "+Y", "-X", "-Y"};
  const double turns = degrees - 360.0 * std::floor(degrees / 360.0);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (turns == 90.0 * static_cast<double>(i)) return axes[i];
  }
  return fmt::format("{:.6g} deg", degrees);
}

std::string cycle_name(const CycleResult& result, std::size_t cycle) {
  if (result.experiment == Experiment::path) return "path";
  if (result.experiment == Experiment::strip) return fmt::format("cycle {}", cycle + 1);
  return direction_name(result.cycles[cycle].direction);
}

std::optional<Failure> failure_of(const Case& input, const CycleResult& result, std::size_t cycle) {
  const Cycle& failed = result.cycles[cycle];
  if (failed.converged()) return std::nullopt;
  Failure failure{.increment = {}, .displacement = 0.0, .reason = std::string(explanation(failed.status))};
  if (failed.increments.empty() || failed.increments.back().converged()) return failure;
  const Increment& last = failed.increments.back();
  failure.increment = last.index;
  failure.displacement = last.displacement;
  if (last.index == 0 && begins_with_preload(input, result, cycle)) {
    failure.reason = "the preload was not reached: " + failure.reason;
  }
  return failure;
}

RunStatus status_of(const CycleResult& result) {
  std::vector<Status> cycles;
  for (const Cycle& cycle : result.cycles) cycles.push_back(cycle.status);
  return run_status(cycles, result.due);
}

std::vector<std::string> failure_lines(const Case& input, const CycleResult& result) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < result.cycles.size(); ++i) {
    const std::optional<Failure> failure = failure_of(input, result, i);
    if (!failure || !failure->increment) continue;
    lines.push_back(fmt::format("{}, increment {} of {}, {:.3g} um: {}", cycle_name(result, i), *failure->increment,
                                result.cycles[i].due - 1, 1e6 * failure->displacement, failure->reason));
  }
  return lines;
}

}  // namespace bumpfoil
