#pragma once

#include <functional>
#include <optional>

#include "bumpfoil/bearing/film_stepper.hpp"
#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/motion/machine.hpp"
#include "bumpfoil/motion/program.hpp"

namespace bumpfoil {

/// An increment of a march, as its observer sees it.
struct Passage {
  const BearingState& from;  ///< state before the increment
  const Step& step;          ///< the increment as it was taken, with the state that it led to; it may have failed
  const Leg& leg;            ///< that it belongs to
  bool ends_leg{};           ///< it is the last one of its leg
  double target{};           ///< where it was to lead on the line of its leg, m or N
};

/// What happens to an increment, and to the march.
enum class Verdict {
  go_on,   ///< its state is kept, and the next increment begins there
  stop,    ///< its state is kept, and is the last one
  refuse,  ///< the state before it stays, and is the last one
  retry,   ///< the state before it stays, and the schedule says what is tried from there
};

/// Called after every increment, failed ones included.
using Observer = std::function<Verdict(const Passage&)>;

/// Takes one increment of a bearing, with a film or without: `taken` = 1..steps of a leg, from a state into `step`. It
/// sets state and status of the step, whose other contents may be of an earlier increment. Following events, crossing
/// folds and halving the increment is its business.
using BearingStepper = std::function<void(const Leg& leg, int taken, const BearingState& from, Step& step)>;

/// Of a bearing without a film.
/// @param stepper  outlives what is returned
/// @param largest  load of the legs, N; of legs by positions any
/// @param reach    loads are not looked for beyond this displacement, m
BearingStepper stepper_of(FoilStepper& stepper, double largest, double reach);

/// Of a running bearing: quasi-static increments by follow(), those that take time by one step of BDF2 each. An
/// increment in time that Newton's method fails to find is taken again in 2, 4, ... 128 equal parts; friction refers to
/// the start of each part.
/// @param stepper  outlives what is returned
BearingStepper stepper_of(FilmStepper& stepper);

/// Decides which leg comes next; nothing at the end. It may depend on what was observed.
using Schedule = std::function<const Leg*()>;

/// That of a program, leg after leg. @param program  outlives the schedule
Schedule schedule_of(const Program& program);

/// Runs through a schedule, increment by increment, by the loop that all marches share. The observer decides what is
/// recorded, accumulated or watched.
/// @param state  where the march begins; receives the last state that was kept
/// @param step   receives the increments, one after the other; its storage is reused
/// @return whether the schedule was taken to its end
bool march(const BearingStepper& take, const Schedule& next_leg, BearingState& state, Step& step,
           const Observer& observe);

/// A step of a machine in time, as its observer sees it.
struct MachineStep {
  MachineReport report;
  MachineState state;  ///< at its end; after a failure the one at its start
};

/// Decides on the next step from the state that was reached; nothing at the end.
using MachineSchedule = std::function<std::optional<TimeStep>(const MachineState&)>;
using MachineObserver = std::function<Verdict(const MachineStep&)>;

/// `count` times the same step, for one march.
MachineSchedule equal_steps(int count, const TimeStep& step);

/// Advances a machine in time, step by step.
/// @param state  where the march begins; receives the last state that was kept
/// @param step   receives the steps, one after the other; its storage is reused
/// @return false if the observer ended it
bool march(MachineStepper& stepper, const MachineSchedule& next_step, const RotorForces& forces, MachineState& state,
           MachineStep& step, const MachineObserver& observe);

}  // namespace bumpfoil
