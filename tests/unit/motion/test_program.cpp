#include "bumpfoil/motion/program.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace bumpfoil {
namespace {

const Line along_y{.base = {1e-6, 0.0}, .direction = Eigen::Vector2d::UnitY()};

TEST(Program, LegsJoinAndEndWhereTheyBegan) {
  for (const Program& program : {one_sided_cycle(Control::displacement, along_y, 2e-6, 8e-6, 4),
                                 fully_reversed_cycle(Control::load, along_y, 20.0, 5.0, 4)}) {
    for (std::size_t i = 1; i < program.size(); ++i) EXPECT_EQ(program[i].begin, program[i - 1].end);
    EXPECT_EQ(program.back().end, program.front().begin);
  }
  EXPECT_EQ(increments_of(one_sided_cycle(Control::displacement, along_y, 0.0, 1.0, 4)), 9);
  EXPECT_EQ(increments_of(fully_reversed_cycle(Control::displacement, along_y, 0.0, 1.0, 4)), 17);
  EXPECT_EQ(fully_reversed_cycle(Control::displacement, along_y, 3.0, 1.0, 4)[1].end, 2.0);
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

TEST(Program, PartsOfAnIncrementLieBetweenItsEnds) {
  const Leg leg = ramp(OperatingPoint::held_at({0.0, 2.0}, 100.0), OperatingPoint::held_at({1.0, 2.0}, 300.0), 2);
  const OperatingPoint part = leg.point(0.5);
  EXPECT_EQ(part.journal, Eigen::Vector2d(0.25, 2.0));
  EXPECT_EQ(part.speed, 150.0);
}

TEST(Program, RevolutionsTakeTheirTimeWhateverTheSense) {
  const OperatingPoint at =
      OperatingPoint::loaded_by({3.0, 4.0}, -200.0 * std::numbers::pi);  // 100 revolutions per second
  const Leg leg = revolutions(at, 2.5, 40);
  EXPECT_EQ(leg.steps, 100);
  EXPECT_DOUBLE_EQ(leg.dt, 1.0 / 4000.0);
  EXPECT_EQ(leg.point(17), at);
}

}  // namespace
}  // namespace bumpfoil
