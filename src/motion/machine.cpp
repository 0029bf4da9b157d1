#include "bumpfoil/motion/machine.hpp"

#include <utility>

#include "core/linear_algebra.hpp"
#include "motion/rotor_journals.hpp"

namespace bumpfoil {
namespace {

/// Maximum number of equal parts of a step.
constexpr int most_parts_of_step = 128;
/// A prediction that reduces P or H below this fraction anywhere is dropped.
constexpr double least_predicted_part = 0.3;

bool keeps_enough(const Matrix& now, const Matrix& predicted) {
  return (predicted.array() >= least_predicted_part * now.array()).all();
}

/// Extrapolates linearly from two states of a bearing. @param w  length of the step over that between the states
/// @return whether the film thickness stays positive
bool go_on(double w, const BearingState& before, const BearingState& now, BearingState& predicted) {
  const auto along = [w](const auto& a, const auto& b, auto& to) { to = b + w * (b - a); };
  along(before.film.pressure, now.film.pressure, predicted.film.pressure);
  along(before.film.thickness, now.film.thickness, predicted.film.thickness);
  if (!keeps_enough(now.film.pressure, predicted.film.pressure)) return false;
  if (!keeps_enough(now.film.thickness, predicted.film.thickness)) return false;
  along(before.film.deflection, now.film.deflection, predicted.film.deflection);
  along(before.film.moment, now.film.moment, predicted.film.moment);
  along(before.film.membrane, now.film.membrane, predicted.film.membrane);
  along(before.contacts.x, now.contacts.x, predicted.contacts.x);
  along(before.contacts.gap, now.contacts.gap, predicted.contacts.gap);
  along(before.contacts.normal_force, now.contacts.normal_force, predicted.contacts.normal_force);
  along(before.contacts.friction_force, now.contacts.friction_force, predicted.contacts.friction_force);
  return true;
}

}  // namespace

MachineStepper::MachineStepper(Rotor rotor, std::vector<FilmStepper*> bearings)
    : rotor_(std::move(rotor)), bearings_(std::move(bearings)), law_(law_of_rotor(rotor_, bearings_)) {}

MachineState MachineStepper::at_rest(std::vector<BearingState> states, const Eigen::VectorXd& forces) const {
  const double speed = states.front().speed;
  RotorMotion rotor{.y = rotor_at_rest(rotor_, bearings_, states, forces), .v = Eigen::VectorXd::Zero(rotor_.size())};
  return {.speed = speed, .rotor = std::move(rotor), .bearings = std::move(states)};
}

/// The rotor as a law of its journals: A y = f + M v_ref / span + (M / span + Omega G + C) y_ref / span - sum B^T F
/// with A = M / span^2 + (Omega G + C) / span + K.
JointMove MachineStepper::move_of(const TimeStep& step, const BackwardDifference& rate, const RotorMotion& reference,
                                  const Eigen::VectorXd& forces) const {
  const Eigen::MatrixXd by_rate = rotor_.mass / rate.span + step.speed * rotor_.gyroscopic + rotor_.damping;
  JointMove move{.law = law_, .speed = step.speed, .dt = step.dt, .scheme = step.scheme};
  JointLaw& law = move.law;
  law.by_place = by_rate / rate.span + rotor_.stiffness;
  law.place =
      solve(law.by_place, Eigen::VectorXd(forces + (rotor_.mass * reference.v + by_rate * reference.y) / rate.span));
  return move;
}

/// First guesses: linear extrapolation if all films allow it, else the last state.
void MachineStepper::guess(double dt, const MachineState& state, Eigen::VectorXd& y) {
  guesses_ = state.bearings;
  y = state.rotor.y;
  if (state.last_dt > 0.0) {
    const double w = dt / state.last_dt;
    bool goes_on = true;
    for (std::size_t i = 0; i < guesses_.size() && goes_on; ++i) {
      goes_on = go_on(w, state.bearings_before[i], state.bearings[i], guesses_[i]);
    }
    if (goes_on) {
      y += w * (state.rotor.y - state.rotor_before.y);
    } else {
      guesses_ = state.bearings;
    }
  }
  for (std::size_t i = 0; i < guesses_.size(); ++i) FilmModel::place_journal(law_.journals[i].place(y), guesses_[i]);
}

FilmReport MachineStepper::take(const TimeStep& step, const RotorForces& forces, MachineState& state) {
  const BackwardDifference rate =
      step.scheme == TimeScheme::bdf2 ? bdf2(step.dt, state.last_dt) : implicit_euler(step.dt);
  const RotorMotion reference{.y = rate.reference(state.rotor.y, state.rotor_before.y),
                              .v = rate.reference(state.rotor.v, state.rotor_before.v)};
  const RotorInstant end{.time = state.time + step.dt,
                         .angle = state.angle + 0.5 * (state.speed + step.speed) * step.dt,
                         .speed = step.speed,
                         .acceleration = (step.speed - state.speed) / step.dt};
  const JointMove move = move_of(step, rate, reference, forces(end));
  Eigen::VectorXd y;
  guess(step.dt, state, y);
  ends_ = state.bearings;
  for (BearingState& bearing : ends_) bearing.begin_increment();
  const FilmReport report = FilmStepper::solve_together(bearings_, move, guesses_, y, ends_);
  if (report.status != Status::converged) return report;
  state.bearings_before.swap(state.bearings);
  state.bearings.swap(ends_);
  state.rotor_before = std::move(state.rotor);
  state.rotor = {.y = y, .v = (y - reference.y) / rate.span};
  state.last_dt = step.dt;
  state.time = end.time;
  state.angle = end.angle;
  state.speed = end.speed;
  return report;
}

MachineReport MachineStepper::advance(const TimeStep& step, const RotorForces& forces, MachineState& state) {
  MachineReport report;
  const auto count = [&](const FilmReport& taken) {
    report.status = taken.status;
    report.iterations += taken.iterations;
    report.factorisations += taken.factorisations;
    return taken.status == Status::converged;
  };
  report.parts = 1;
  if (count(take(step, forces, state))) return report;
  const double begin = state.speed;
  while (report.status == Status::not_converged && report.parts < most_parts_of_step) {
    report.parts *= 2;
    MachineState trial = state;
    int taken = 0;
    do {
      ++taken;
      const double end = begin + (step.speed - begin) * taken / report.parts;
      const TimeStep part{.dt = step.dt / report.parts, .speed = end, .scheme = step.scheme};
      if (!count(take(part, forces, trial))) break;
    } while (taken < report.parts);
    if (report.status == Status::converged) state = std::move(trial);
  }
  return report;
}

}  // namespace bumpfoil
