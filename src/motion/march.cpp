#include "bumpfoil/motion/march.hpp"

#include <utility>

#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/load_search.hpp"

namespace bumpfoil {
namespace {

/// A load of zero is replaced by this fraction of the largest: without contact the position would be undetermined.
constexpr double least_load = 1e-6;
/// Maximum number of equal parts of an increment in time.
constexpr int most_parts = 128;

/// A load that keeps the journal on its current or next side of the clearance.
/// @param largest  load of the program
Eigen::Vector2d never_zero(const Eigen::Vector2d& load, double largest, const Leg& leg, const Foils& foils,
                           const BearingState& state) {
  const double least = least_load * largest;
  if (load.norm() >= least) return load;
  const Eigen::Vector2d begin = leg.line.place(leg.begin);
  const Eigen::Vector2d end = leg.line.place(leg.end);
  const Eigen::Vector2d larger = end.norm() > begin.norm() ? end : begin;
  if (larger.norm() >= least) return least * larger.normalized();
  const Eigen::Vector2d carried = holding_force(foils, state.contacts.normal_force);
  return least * (carried.norm() > 0.0 ? Eigen::Vector2d(carried.normalized()) : Eigen::Vector2d::UnitX());
}

/// An increment in time, in as many parts as it needs.
void pass_time(FilmStepper& stepper, const Leg& leg, int taken, const BearingState& from, Step& step) {
  step.film = {};
  for (int parts = 1; parts <= most_parts; parts *= 2) {
    step.state = from;
    step.substeps = parts - 1;
    int part = 1;
    do {
      const OperatingPoint to = leg.point(taken - 1 + static_cast<double>(part) / parts);
      step.film += stepper.advance(stepper.move_to(to, leg.dt / parts), step.state);
    } while (step.film.status == Status::converged && ++part <= parts);
    if (step.film.status != Status::not_converged) return;
  }
}

}  // namespace

Schedule schedule_of(const Program& program) {
  return [&program, next = program.begin()]() mutable { return next == program.end() ? nullptr : &*next++; };
}

bool march(const Schedule& next_leg, const Taker& take, BearingState& state, Step& step, const Observer& observe) {
  while (const Leg* leg = next_leg()) {
    for (int taken = 1; taken <= leg->steps; ++taken) {
      take(*leg, taken, state, step);
      const Verdict verdict = observe(
          {.from = state, .step = step, .leg = *leg, .ends_leg = taken == leg->steps, .target = leg->target(taken)});
      if (verdict == Verdict::refuse) return false;
      if (verdict == Verdict::retry) break;
      std::swap(state, step.state);
      if (verdict == Verdict::stop) return false;
    }
  }
  return true;
}

bool march(FoilStepper& stepper, const Schedule& next_leg, double largest, double reach, BearingState& state,
           Step& step, const Observer& observe) {
  const auto take = [&](const Leg& leg, int taken, const BearingState& from, Step& next) {
    const Eigen::Vector2d place = leg.line.place(leg.target(taken));
    if (leg.control == Control::load) {
      const Eigen::Vector2d load = never_zero(place, largest, leg, stepper.foils(), from);
      const double none = least_load * largest * (1.0 + 1e-9);  // including the round-off of the least load
      advance_to_load(stepper, from, load, none, reach, next);
      return;
    }
    if (taken == 1) {
      Excitation end = from;
      end.position = leg.line.place(leg.end);
      stepper.set_out(from, end);
    }
    stepper.advance_to(static_cast<double>(taken) / leg.steps, from, next);
    next.state.position = place;
  };
  return march(next_leg, take, state, step, observe);
}

bool march(FoilStepper& stepper, const Program& program, double reach, BearingState& state, Step& step,
           const Observer& observe) {
  return march(stepper, schedule_of(program), largest_place(program), reach, state, step, observe);
}

bool march(FilmStepper& stepper, const Program& program, BearingState& state, Step& step, const Observer& observe) {
  const auto take = [&](const Leg& leg, int taken, const BearingState& from, Step& next) {
    if (leg.dt > 0.0) {
      pass_time(stepper, leg, taken, from, next);
    } else {
      next.state = from;
      next.substeps = 0;
      next.film = follow(stepper, leg.point(taken), next.state);
    }
    next.status = next.film.status;
  };
  return march(schedule_of(program), take, state, step, observe);
}

}  // namespace bumpfoil
