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

/// Takes increment `taken` = 1..steps of a leg from a state into `step`.
using Taker = std::function<void(const Leg& leg, int taken, const BearingState& from, Step& step)>;

/// Decides which leg comes next; nothing at the end. It may depend on what was observed.
using Schedule = std::function<const Leg*()>;

/// That of a program, leg after leg. @param program  outlives the schedule
Schedule schedule_of(const Program& program);

/// Runs through a schedule, increment by increment, by the loop that all marches share. The observer decides what is
/// recorded, accumulated or watched; halving increments, following events and crossing folds is done by the stepper.
/// @param state  where the march begins; receives the last state that was kept
/// @param step   receives the increments, one after the other; its storage is reused
/// @return whether the schedule was taken to its end
bool march(const Schedule& next_leg, const Taker& take, BearingState& state, Step& step, const Observer& observe);

/// Runs foils through a schedule.
/// @param largest  load of the schedule, N; of one by positions any
/// @param reach    loads are not looked for beyond this displacement, m
bool march(FoilStepper& stepper, const Schedule& next_leg, double largest, double reach, BearingState& state,
           Step& step, const Observer& observe);

/// Takes foils through a program.
bool march(FoilStepper& stepper, const Program& program, double reach, BearingState& state, Step& step,
           const Observer& observe);

/// Runs a running bearing through a program: quasi-static increments by follow(), those that take time by one step of
/// BDF2 each. An increment in time that Newton's method fails to find is taken again in 2, 4, ... 128 equal parts;
/// friction refers to the start of each part.
bool march(FilmStepper& stepper, const Program& program, BearingState& state, Step& step, const Observer& observe);

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
