#include "bumpfoil/motion/rotor_equilibria.hpp"

#include <cstddef>
#include <utility>

#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "bumpfoil/motion/start.hpp"

namespace bumpfoil {
namespace {

/// Where journals are held at the cold start, in what a journal at the centre has everywhere, along their loads.
constexpr double held_along_load = 0.1;
/// Increments in which a clearance closes that had to be opened for the first state.
constexpr int starting_steps = 10;

}  // namespace

RotorEquilibria::RotorEquilibria(const Rotor& rotor, std::vector<FilmStepper*> steppers, const Eigen::Vector2d& gravity)
    : steppers_(std::move(steppers)), loads_(weights_on_bearings(rotor, gravity)) {}

Status RotorEquilibria::go_to(double speed, std::vector<BearingState>& states) const {
  const bool starts = states.empty();
  states.resize(steppers_.size());
  for (std::size_t i = 0; i < steppers_.size(); ++i) {
    const FilmReport report = starts ? start(i, speed, states[i])
                                     : follow(*steppers_[i], OperatingPoint::loaded_by(loads_[i], speed), states[i]);
    if (report.status != Status::converged) return report.status;
  }
  return Status::converged;
}

FilmReport RotorEquilibria::start(std::size_t bearing, double speed, BearingState& state) const {
  const Eigen::Vector2d& load = loads_[bearing];
  const OperatingPoint loaded = OperatingPoint::loaded_by(load, speed);
  const auto begin = [&](FilmStepper& stepper, double opening, BearingState& begun) {
    const Eigen::Vector2d held = held_along_load * (stepper.bearing().room + opening) * load.normalized();
    FilmReport report = cold_start(stepper, held, speed, begun, opening);
    if (report.status != Status::converged) return report;
    OperatingPoint opened = loaded;
    opened.opening = opening;
    report += settle(stepper, opened, begun);
    if (report.status == Status::converged && opening > 0.0) {
      report += close_clearance(stepper, loaded, starting_steps, begun);
    }
    return report;
  };
  return start_from_rest(*steppers_[bearing], loaded, starting_steps, begin, state);
}

std::vector<CarryingBearing> RotorEquilibria::carrying(const std::vector<BearingState>& states) const {
  std::vector<CarryingBearing> bearings;
  bearings.reserve(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) bearings.push_back({*steppers_[i], states[i]});
  return bearings;
}

}  // namespace bumpfoil
