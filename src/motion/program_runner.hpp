#pragma once

#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/motion/program.hpp"

namespace bumpfoil {

/// Takes foils through a program, increment by increment.
class ProgramRunner {
 public:
  /// @param stepper, state  outlive the runner; `state` is where the program begins, and follows it
  /// @param reach           loads are not looked for beyond this displacement, m
  ProgramRunner(FoilStepper& stepper, const Program& program, double reach, FoilState& state)
      : stepper_(stepper), program_(program), reach_(reach), state_(state), largest_(largest_place(program)) {}

  /// Whether there is another increment to take.
  [[nodiscard]] bool has_next() const { return leg_ < program_.size(); }
  /// The leg that the next increment belongs to.
  [[nodiscard]] const Leg& leg() const { return program_[leg_]; }
  /// Whether the next increment is the last of its leg.
  [[nodiscard]] bool ends_leg() const { return taken_ + 1 == leg().steps; }

  /// Where the next increment leads on the line of its leg, m or N.
  [[nodiscard]] double target() const { return leg().target(taken_ + 1); }

  /// Takes the next increment. `step` receives it; commit() or nothing must follow.
  void try_next(Step& step);

  /// Makes what try_next() gave the new state.
  void commit(Step& step);

 private:
  [[nodiscard]] Eigen::Vector2d never_zero(const Eigen::Vector2d& load) const;

  FoilStepper& stepper_;
  const Program& program_;
  double reach_;
  FoilState& state_;
  std::size_t leg_{};
  double largest_;  ///< largest load or displacement of the program
  int taken_{};     ///< increments of the leg
};

}  // namespace bumpfoil
