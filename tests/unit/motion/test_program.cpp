#include "bumpfoil/motion/program.hpp"

#include <gtest/gtest.h>

#include "motion/program_runner.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

const Line along_y{.base = {1e-6, 0.0}, .direction = Eigen::Vector2d::UnitY()};

TEST(Program, LegsJoinAndEndWhereTheyBegan) {
  for (const Program& program :
       {push_and_pull(Control::displacement, along_y, 2e-6, 8e-6, 4), swing(Control::load, along_y, 20.0, 5.0, 4)}) {
    for (std::size_t i = 1; i < program.size(); ++i) EXPECT_EQ(program[i].begin, program[i - 1].end);
    EXPECT_EQ(program.back().end, program.front().begin);
  }
  EXPECT_EQ(increments_of(push_and_pull(Control::displacement, along_y, 0.0, 1.0, 4)), 9);
  EXPECT_EQ(increments_of(swing(Control::displacement, along_y, 0.0, 1.0, 4)), 17);
  EXPECT_EQ(swing(Control::displacement, along_y, 3.0, 1.0, 4)[1].end, 2.0);
}

TEST(Program, TargetsAreEqualPartsThatMeetTheEndsExactly) {
  const Leg leg{.branch = Branch::loading,
                .control = Control::displacement,
                .line = along_y,
                .begin = 0.25,
                .end = 1.0,
                .steps = 3};
  EXPECT_EQ(leg.target(0), 0.25);
  EXPECT_EQ(leg.target(1), 0.5);
  EXPECT_EQ(leg.target(3), 1.0);
  EXPECT_EQ(leg.line.place(0.7), Eigen::Vector2d(1e-6, 0.7));
}

TEST(ProgramRunner, TakesLegsOfBothKindsAndKeepsTheStateUntilItIsToldTo) {
  const SharedFoils foils = make_bearing_foils(case_with_given_constants());
  FoilStepper stepper(foils, {});
  Step step;
  stepper.assemble({}, step);
  FoilState state = step.state;
  const Line along_x{};
  const Program program{{Branch::loading, Control::displacement, along_x, 0.0, 60e-6, 3},
                        {Branch::loading, Control::load, along_x, 300.0, 400.0, 2}};
  ProgramRunner runner(stepper, program, 0.3e-3, state);
  int taken = 0;
  for (; runner.has_next(); runner.commit(step)) {
    const Eigen::Vector2d before = state.excitation.position;
    const Leg leg = runner.leg();
    const double target = runner.target();
    runner.try_next(step);
    ASSERT_TRUE(step.converged()) << taken;
    EXPECT_EQ(state.excitation.position, before);
    if (leg.control == Control::displacement) {
      EXPECT_EQ(step.state.excitation.position, Eigen::Vector2d(target, 0.0));
    } else {
      const Eigen::Vector2d force = holding_force(*foils, step.state.contacts.normal_force);
      EXPECT_LT((force - Eigen::Vector2d(target, 0.0)).norm(), 1e-6);
    }
    ++taken;
  }
  EXPECT_EQ(taken, 5);
}

/// Under no load the place would not be determined: a millionth of the largest stands for it.
TEST(ProgramRunner, ALoadOfZeroIsAMillionthOfTheLargest) {
  const SharedFoils foils = make_bearing_foils(case_with_given_constants());
  FoilStepper stepper(foils, {});
  Step step;
  stepper.assemble({}, step);
  FoilState state = step.state;
  const Program program{{Branch::loading, Control::load, {}, 0.0, 100.0, 1},
                        {Branch::unloading, Control::load, {}, 100.0, 0.0, 1}};
  ProgramRunner runner(stepper, program, 0.3e-3, state);
  for (; runner.has_next(); runner.commit(step)) {
    runner.try_next(step);
    ASSERT_TRUE(step.converged());
  }
  EXPECT_NEAR(holding_force(*foils, state.contacts.normal_force).x(), 1e-4, 1e-8);
}

}  // namespace
}  // namespace bumpfoil
