#include "bumpfoil/motion/march.hpp"

#include <utility>

#include "bumpfoil/motion/load_search.hpp"

namespace bumpfoil {
namespace {

/// A load of zero stands for this part of the largest: where nothing is touched the place would not be determined.
constexpr double least_load = 1e-6;

/// A load that keeps the body on the side that it is on, or is to be on next.
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

}  // namespace

bool march(FoilStepper& stepper, const Program& program, double reach, BearingState& state, Step& step,
           const Observer& observe) {
  const double largest = largest_place(program);
  for (const Leg& leg : program) {
    if (leg.control == Control::displacement) {
      Excitation end = state;
      end.position = leg.line.place(leg.end);
      stepper.set_out(state, end);
    }
    for (int taken = 1; taken <= leg.steps; ++taken) {
      const double target = leg.target(taken);
      const Eigen::Vector2d place = leg.line.place(target);
      if (leg.control == Control::load) {
        const Eigen::Vector2d load = never_zero(place, largest, leg, stepper.foils(), state);
        const double none = least_load * largest * (1.0 + 1e-9);  // round-off of the least load included
        advance_to_load(stepper, state, load, none, reach, step);
      } else {
        stepper.advance_to(static_cast<double>(taken) / leg.steps, state, step);
        step.state.position = place;
      }
      const Verdict verdict =
          observe({.from = state, .step = step, .leg = leg, .ends_leg = taken == leg.steps, .target = target});
      if (verdict == Verdict::refuse) return false;
      std::swap(state, step.state);
      if (verdict == Verdict::stop) return false;
    }
  }
  return true;
}

}  // namespace bumpfoil
