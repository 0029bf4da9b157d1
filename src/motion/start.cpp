#include "bumpfoil/motion/start.hpp"

#include "bumpfoil/motion/march.hpp"
#include "bumpfoil/motion/program.hpp"
#include "bumpfoil/motion/rest.hpp"

namespace bumpfoil {
namespace {

/// Minimum film thickness after a start from ambient pressure, as fraction of the available clearance.
constexpr double room_left_by_journal = 0.3;

}  // namespace

double clearance_offset_to_start(const BearingModel& bearing, double floor) {
  const bool has_room =
      bearing.film->assembled_clearance > 0.0 && room_left_by_journal * bearing.film->assembled_clearance >= floor;
  return has_room ? 0.0 : bearing.film->scales.thickness - bearing.film->assembled_clearance;
}

FilmReport close_clearance(FilmStepper& stepper, const OperatingPoint& to, int steps, BearingState& state) {
  FilmReport report{.status = Status::converged};
  const OperatingPoint from = point_of(stepper.bearing(), state, to);
  Step step;
  const Program closing{ramp(from, to, steps)};
  march(stepper_of(stepper), schedule_of(closing), state, step, [&](const Passage& at) {
    report += at.step.film;
    return at.step.converged() ? Verdict::go_on : Verdict::stop;
  });
  return report;
}

FilmReport start_from_rest(FilmStepper& stepper, const OperatingPoint& to, int steps, const Beginning& begin,
                           BearingState& state) {
  const BearingModel& bearing = stepper.bearing();
  const FilmBearingOptions& options = stepper.options();
  const double floor = options.newton.thickness_floor * bearing.film->scales.thickness;
  const double clearance_offset = clearance_offset_to_start(bearing, floor);
  if (clearance_offset == 0.0 || bearing.assembly.empty()) return begin(stepper, clearance_offset, state);
  FilmStepper unformed(formed_by(bearing, 0.0), options);
  FilmReport report = begin(unformed, clearance_offset_to_start(unformed.bearing(), floor), state);
  for (int i = 1; i < steps && report.status == Status::converged; ++i) {
    FilmStepper forming(formed_by(bearing, static_cast<double>(i) / steps), options);
    report += settle(forming, to, state);
  }
  if (report.status == Status::converged) report += settle(stepper, to, state);
  return report;
}

}  // namespace bumpfoil
