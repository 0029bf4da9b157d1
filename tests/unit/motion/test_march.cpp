#include "bumpfoil/motion/march.hpp"

#include <gtest/gtest.h>

#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

/// The assembled reference bearing, where a march begins.
class March : public ::testing::Test {
 protected:
  March() {
    stepper_.assemble({}, step_);
    state_ = step_.state;
  }

  [[nodiscard]] bool take(const Program& program, const Observer& observe) {
    return march(stepper_, program, 0.3e-3, state_, step_, observe);
  }

  SharedFoils foils_{make_bearing_foils(case_with_given_constants())};
  FoilStepper stepper_{foils_, {}};
  Step step_;
  BearingState state_;
};

const Program push{{Branch::loading, Control::displacement, {}, 0.0, 60e-6, 3}};

TEST_F(March, TakesLegsOfBothKinds) {
  Program program = push;
  program.push_back({Branch::loading, Control::load, {}, 300.0, 400.0, 2});
  int taken = 0;
  Eigen::Vector2d before = state_.position;
  const bool all = take(program, [&](const Passage& at) {
    EXPECT_TRUE(at.step.converged()) << taken;
    EXPECT_EQ(at.from.position, before);
    before = at.step.state.position;
    if (at.leg.control == Control::displacement) {
      EXPECT_EQ(before, Eigen::Vector2d(at.target, 0.0));
    } else {
      const Eigen::Vector2d force = holding_force(*foils_, at.step.state.contacts.normal_force);
      EXPECT_LT((force - Eigen::Vector2d(at.target, 0.0)).norm(), 1e-6);
    }
    ++taken;
    EXPECT_EQ(at.ends_leg, taken == 3 || taken == 5);
    return Verdict::go_on;
  });
  EXPECT_TRUE(all);
  EXPECT_EQ(taken, 5);
  EXPECT_EQ(state_.position, before);
}

TEST_F(March, KeepsTheStateOfAnIncrementThatStopsItAndNotOfOneThatIsRefused) {
  for (const Verdict verdict : {Verdict::stop, Verdict::refuse}) {
    stepper_.assemble({}, step_);
    state_ = step_.state;
    int taken = 0;
    EXPECT_FALSE(take(push, [&](const Passage&) { return ++taken == 2 ? verdict : Verdict::go_on; }));
    EXPECT_EQ(taken, 2);
    EXPECT_DOUBLE_EQ(state_.position.x(), verdict == Verdict::stop ? 40e-6 : 20e-6);
  }
}

/// Under no load the place would not be determined: a millionth of the largest stands for it.
TEST_F(March, ALoadOfZeroIsAMillionthOfTheLargest) {
  const Program program{{Branch::loading, Control::load, {}, 0.0, 100.0, 1},
                        {Branch::unloading, Control::load, {}, 100.0, 0.0, 1}};
  ASSERT_TRUE(take(program, [](const Passage& at) { return at.step.converged() ? Verdict::go_on : Verdict::refuse; }));
  EXPECT_NEAR(holding_force(*foils_, state_.contacts.normal_force).x(), 1e-4, 1e-8);
}

}  // namespace
}  // namespace bumpfoil
