#include "bumpfoil/experiments/strip/strip.hpp"

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "experiments/cycle/cycle_series.hpp"
#include "experiments/cycle/run_each_cycle.hpp"

namespace bumpfoil {

CycleResult run_strip(const Case& input, const ProgressCallback& progress, Recording recording) {
  const SharedBearing foils = make_strip_foils(input);
  const StripSettings& strip = input.settings.get<StripSettings>();
  CycleCourse course{.direction = 0.0,
                     .amplitude = strip.amplitude,
                     .preload = {},
                     .fully_reversed = strip.preload.has_value(),
                     .steps = strip.steps,
                     .reach = foils->rise};
  if (strip.preload) course.preload = {strip.preload->control, {strip.preload->value, 0.0}};
  FoilStepper stepper = make_stepper(foils, input.solver);
  Step step;
  CycleSeries series(stepper, course, {}, step);
  return run_each_cycle(Experiment::strip, input, strip.cycles, progress,
                        [&](std::size_t, const ProgressCallback& progress_of_cycle) {
                          return series.next(recording, progress_of_cycle);
                        });
}

}  // namespace bumpfoil
