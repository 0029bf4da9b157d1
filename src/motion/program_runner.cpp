#include "motion/program_runner.hpp"

#include <utility>

#include "bumpfoil/motion/load_search.hpp"

namespace bumpfoil {
namespace {

/// A load of zero stands for this part of the largest: where nothing is touched the place would not be determined.
constexpr double least_load = 1e-6;

}  // namespace

/// A load that keeps the body on the side that it is on, or is to be on next.
Eigen::Vector2d ProgramRunner::never_zero(const Eigen::Vector2d& load) const {
  const double least = least_load * largest_;
  if (load.norm() >= least) return load;
  const Eigen::Vector2d begin = leg().line.place(leg().begin);
  const Eigen::Vector2d end = leg().line.place(leg().end);
  const Eigen::Vector2d larger = end.norm() > begin.norm() ? end : begin;
  if (larger.norm() >= least) return least * larger.normalized();
  const Eigen::Vector2d carried = holding_force(stepper_.foils(), state_.contacts.normal_force);
  return least * (carried.norm() > 0.0 ? Eigen::Vector2d(carried.normalized()) : Eigen::Vector2d::UnitX());
}

void ProgramRunner::try_next(Step& step) {
  const Leg& next = leg();
  const Eigen::Vector2d place = next.line.place(target());
  if (next.control == Control::load) {
    const Eigen::Vector2d load = never_zero(place);
    const double none = least_load * largest_ * (1.0 + 1e-9);  // roundings of the least load included
    advance_to_load(stepper_, state_, load, none, reach_, step);
    return;
  }
  if (taken_ == 0) {
    Excitation end = state_.excitation;
    end.position = next.line.place(next.end);
    stepper_.set_out(state_, end);
  }
  stepper_.advance_to(static_cast<double>(taken_ + 1) / next.steps, state_, step);
  step.state.excitation.position = place;
}

void ProgramRunner::commit(Step& step) {
  std::swap(state_, step.state);
  if (++taken_ < leg().steps) return;
  ++leg_;
  taken_ = 0;
}

}  // namespace bumpfoil
