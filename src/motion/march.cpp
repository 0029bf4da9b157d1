#include "bumpfoil/motion/march.hpp"

#include <optional>
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
Eigen::Vector2d never_zero(const Eigen::Vector2d& load, double largest, const Leg& leg, const BearingModel& foils,
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

/// The loop of every march: increments one after the other, each from the last state that was kept.
/// @param next  next(state): the next increment, or nothing
/// @param take  take(increment, state, step): leads from the state into the step
template <typename Next, typename Take, typename State, typename Taken, typename Observe>
bool run_through(const Next& next, const Take& take, State& state, Taken& step, const Observe& observe) {
  while (const auto increment = next(state)) {
    take(*increment, state, step);
    const Verdict verdict = observe(*increment, state, step);
    if (verdict == Verdict::refuse) return false;
    if (verdict == Verdict::retry) continue;
    std::swap(state, step.state);
    if (verdict == Verdict::stop) return false;
  }
  return true;
}

/// Increment `taken` = 1..steps of a leg.
struct LegIncrement {
  const Leg* leg{};
  int taken{};
};

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

bool march(const BearingStepper& take, const Schedule& next_leg, BearingState& state, Step& step,
           const Observer& observe) {
  LegIncrement at;  // the last one that was taken
  const auto next = [&](const BearingState&) -> std::optional<LegIncrement> {
    while (at.leg == nullptr || at.taken >= at.leg->steps) {
      at = {next_leg(), 0};
      if (at.leg == nullptr) return std::nullopt;
    }
    ++at.taken;
    return at;
  };
  const auto take_one = [&](const LegIncrement& one, const BearingState& from, Step& to) {
    take(*one.leg, one.taken, from, to);
  };
  return run_through(next, take_one, state, step, [&](const LegIncrement& one, const BearingState& from, Step& to) {
    const Leg& leg = *one.leg;
    const Verdict verdict = observe(
        {.from = from, .step = to, .leg = leg, .ends_leg = one.taken == leg.steps, .target = leg.target(one.taken)});
    if (verdict == Verdict::retry) at.leg = nullptr;  // the rest of the leg is left out
    return verdict;
  });
}

BearingStepper stepper_of(FoilStepper& stepper, double largest, double reach) {
  return [&stepper, largest, reach](const Leg& leg, int taken, const BearingState& from, Step& step) {
    const Eigen::Vector2d place = leg.line.place(leg.target(taken));
    if (leg.control == Control::load) {
      const Eigen::Vector2d load = never_zero(place, largest, leg, stepper.foils(), from);
      const double none = least_load * largest * (1.0 + 1e-9);  // including the round-off of the least load
      advance_to_load(stepper, from, load, none, reach, step);
      return;
    }
    if (taken == 1) {
      Excitation end = from;
      end.position = leg.line.place(leg.end);
      stepper.set_out(from, end);
    }
    stepper.advance_to(static_cast<double>(taken) / leg.steps, from, step);
    step.state.position = place;
  };
}

BearingStepper stepper_of(FilmStepper& stepper) {
  return [&stepper](const Leg& leg, int taken, const BearingState& from, Step& step) {
    if (leg.dt > 0.0) {
      pass_time(stepper, leg, taken, from, step);
    } else {
      step.state = from;
      step.substeps = 0;
      step.film = follow(stepper, leg.point(taken), step.state);
    }
    step.status = step.film.status;
  };
}

MachineSchedule equal_steps(int count, const TimeStep& step) {
  return [count, step, taken = 0](const MachineState&) mutable {
    return taken++ < count ? std::optional(step) : std::nullopt;
  };
}

bool march(MachineStepper& stepper, const MachineSchedule& next_step, const RotorForces& forces, MachineState& state,
           MachineStep& step, const MachineObserver& observe) {
  const auto take = [&](const TimeStep& taken, const MachineState& from, MachineStep& to) {
    to.state = from;
    to.report = stepper.advance(taken, forces, to.state);
  };
  return run_through(next_step, take, state, step,
                     [&](const TimeStep&, const MachineState&, const MachineStep& to) { return observe(to); });
}

}  // namespace bumpfoil
