#pragma once

#include <functional>

#include "bumpfoil/bearing/foil_stepper.hpp"
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

/// What becomes of an increment, and of the march.
enum class Verdict {
  go_on,   ///< its state is kept, and the next increment begins there
  stop,    ///< its state is kept, and is the last one
  refuse,  ///< the state before it stays, and is the last one
};

/// Called after every increment, failed ones included: these are to be refused.
using Observer = std::function<Verdict(const Passage&)>;

/// Takes foils through a program, increment by increment: the one loop that does so. What is recorded, accumulated or
/// watched for is the observer's business; halving increments and following events is the stepper's.
/// @param reach  loads are not looked for beyond this displacement, m
/// @param state  where the program begins; receives the last state that was kept
/// @param step   receives the increments, one after the other; its storage is reused
/// @return whether the program was taken to its end
bool march(FoilStepper& stepper, const Program& program, double reach, BearingState& state, Step& step,
           const Observer& observe);

}  // namespace bumpfoil
