#include "bumpfoil/motion/rotor_equilibria.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "bumpfoil/motion/start.hpp"
#include "core/linear_algebra.hpp"
#include "motion/rotor_journals.hpp"

namespace bumpfoil {
namespace {

/// Initial journal displacement in the direction of the load, relative to the clearance available everywhere to a
/// centred journal.
constexpr double held_along_load = 0.1;
/// Number of increments to close a clearance that was opened for the first state.
constexpr int starting_steps = 10;

}  // namespace

RotorEquilibria::RotorEquilibria(const Rotor& rotor, std::vector<FilmStepper*> steppers, const Eigen::Vector2d& gravity)
    : rotor_(rotor),
      weight_(rotor.inertia_force(gravity)),
      steppers_(std::move(steppers)),
      law_(law_of_rotor(rotor_, steppers_)),
      loads_(weights_on_bearings(rotor, gravity)) {}

Status RotorEquilibria::go_to(double speed, std::vector<BearingState>& states) const {
  const bool starts = states.empty();
  states.resize(steppers_.size());
  for (std::size_t i = 0; i < steppers_.size(); ++i) {
    const FilmReport report =
        starts ? start(i, speed, states[i]) : follow(*steppers_[i], next_point(i, speed, states[i]), states[i]);
    if (report.status != Status::converged) return report.status;
  }
  const bool resists_tilts = std::any_of(steppers_.begin(), steppers_.end(),
                                         [](const FilmStepper* stepper) { return stepper->film().tilts(); });
  return resists_tilts ? join(speed, states).status : Status::converged;
}

/// The next point of a bearing before it is coupled by the rotor: with its current force and tilt.
OperatingPoint RotorEquilibria::next_point(std::size_t bearing, double speed, const BearingState& state) const {
  OperatingPoint point = OperatingPoint::loaded_by(loads_[bearing], speed);
  const FilmStepper& stepper = *steppers_[bearing];
  if (!stepper.film().tilts()) return point;
  point = point_of(stepper.bearing(), state, point);
  point.speed = speed;
  return point;
}

/// Lets the rotor tilt and bend in the same increment until forces and moments of all bearings balance its weight.
FilmReport RotorEquilibria::join(double speed, std::vector<BearingState>& states) const {
  // K (y* - y) + sum B^T (F* - F) = 0, where the loads F* balance the rigid part of the weight.
  JointMove move{.law = law_, .speed = speed};
  JointLaw& law = move.law;
  law.by_place = rotor_.stiffness;
  Eigen::VectorXd bending = weight_;
  for (std::size_t i = 0; i < steppers_.size(); ++i) {
    law.journals[i].force.head<2>() = loads_[i];
    bending -= law.journals[i].by_force * law.journals[i].force;
  }
  const double largest = rotor_.stiffness.cwiseAbs().maxCoeff();
  law.place = Eigen::VectorXd::Zero(rotor_.size());
  if (largest > 0.0) {
    law.place = least_squares(rotor_.stiffness / largest, bending / largest);
  }
  Eigen::VectorXd y = rotor_at_rest(rotor_, steppers_, states, weight_);
  std::vector<BearingState> guesses = states;
  for (std::size_t i = 0; i < guesses.size(); ++i) FilmModel::place_journal(law.journals[i].place(y), guesses[i]);
  return FilmStepper::solve_together(steppers_, move, guesses, y, states);
}

FilmReport RotorEquilibria::start(std::size_t bearing, double speed, BearingState& state) const {
  const Eigen::Vector2d& load = loads_[bearing];
  const OperatingPoint loaded = OperatingPoint::loaded_by(load, speed);
  const auto begin = [&](FilmStepper& stepper, double clearance_offset, BearingState& begun) {
    const Eigen::Vector2d held =
        held_along_load * (stepper.film().assembled_clearance + clearance_offset) * load.normalized();
    FilmReport report = start_from_ambient(stepper, held, speed, begun, clearance_offset);
    if (report.status != Status::converged) return report;
    OperatingPoint opened = loaded;
    opened.clearance_offset = clearance_offset;
    report += settle(stepper, opened, begun);
    if (report.status == Status::converged && clearance_offset > 0.0) {
      report += close_clearance(stepper, loaded, starting_steps, begun);
    }
    return report;
  };
  FilmReport report = start_from_rest(*steppers_[bearing], loaded, starting_steps, begin, state);
  OperatingPoint tilted = loaded;
  tilted.tilt = steppers_[bearing]->film().surroundings.tilt;
  if (report.status == Status::converged && tilted != loaded) report += follow(*steppers_[bearing], tilted, state);
  return report;
}

std::vector<CarryingBearing> RotorEquilibria::carrying(const std::vector<BearingState>& states) const {
  std::vector<CarryingBearing> bearings;
  bearings.reserve(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) bearings.push_back({*steppers_[i], states[i]});
  return bearings;
}

}  // namespace bumpfoil
