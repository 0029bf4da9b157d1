#include "bumpfoil/analysis/strip.hpp"

#include "analysis/loop_runner.hpp"
#include "analysis/run_loops.hpp"
#include "bumpfoil/analysis/cycle_quantities.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

const Eigen::Vector2d towards_base(1.0, 0.0);

/// One increment of the plate.
bool advance(PathRunner& path, PlateControl control, double value, double reach) {
  return control == PlateControl::load ? path.load_to(towards_base, value, reach) : path.move_to(value * towards_base);
}

/// Assembles the strip and brings the plate to its preload, if there is one.
/// @return what cycles are counted from, a displacement or a load; absent after a failure
std::optional<double> approach(PathRunner& path, const StripSettings& strip, double reach) {
  if (!path.assemble(Eigen::Vector2d::Zero())) return std::nullopt;
  if (!strip.preload) return 0.0;
  for (int k = 1; k <= strip.steps; ++k) {
    if (!advance(path, strip.preload->control, strip.preload->value * k / strip.steps, reach)) return std::nullopt;
  }
  path.reset_books();
  const bool by_load = strip.amplitude.control == PlateControl::load;
  return by_load ? strip.preload->value : path.record(towards_base).displacement;
}

/// Quantities of a cycle that a strip defines in its own way, once it got to the turning point.
void derive_strip_quantities(const StripSettings& strip, Cycle& cycle) {
  if (!cycle.turning_point) return;
  const Increment& start = cycle.increments.front();
  const Increment& top = cycle.at_turning_point();
  const auto lower = static_cast<std::size_t>(3 * cycle.steps);
  const Increment& bottom = strip.preload && lower < cycle.increments.size() ? cycle.increments[lower] : start;
  cycle.amplitude = top.displacement - start.displacement;
  cycle.turning_point->secant_stiffness =
      (top.force_direct - bottom.force_direct) / (top.displacement - bottom.displacement);
  if (strip.preload && cycle.loop_energy) {
    const double stored = 0.5 * cycle.turning_point->secant_stiffness * cycle.amplitude * cycle.amplitude;
    cycle.loss_factor = loss_factor(*cycle.loop_energy, stored);
  }
}

}  // namespace

CycleResult run_strip(const Case& input, const ProgressCallback& progress) {
  const FoilModel model = make_strip_model(input);
  const StripSettings& strip = *input.strip;
  const double reach = nominal_bump(input.bump_foil).rise;  // bumps are flat there
  const bool by_load = strip.amplitude.control == PlateControl::load;
  PathRunner path(model, input.solver);
  double origin = 0.0;
  const auto make_runner = [&](std::size_t i) {
    const auto begin = [&, i](PathRunner& runner) -> std::optional<double> {
      if (i > 0) {
        runner.reset_books();
        return origin;
      }
      const std::optional<double> reached = approach(runner, strip, reach);
      if (reached) origin = *reached;
      return reached;
    };
    Cycle cycle;
    cycle.steps = strip.steps;
    if (!by_load) cycle.amplitude = strip.amplitude.value;
    const double amplitude = strip.amplitude.value;
    return LoopRunner(path,
                      {.normal = towards_base,
                       .legs = strip.preload ? swing(amplitude, strip.steps) : push_and_pull(amplitude, strip.steps),
                       .by_load = by_load,
                       .reach = reach,
                       .begin = begin,
                       .assembles = i == 0},
                      cycle);
  };
  CycleResult result = run_loops(Experiment::strip, input, strip.cycles, progress, make_runner);
  for (Cycle& cycle : result.cycles) derive_strip_quantities(strip, cycle);
  return result;
}

}  // namespace bumpfoil
