#include "analysis/energy.hpp"

#include <gtest/gtest.h>

#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// One unknown against a wall, and one slipping contact; forces and gaps are made up.
ContactProblem two_contacts() {
  ContactProblem problem;
  problem.K = BlockTridiagonal(1, 3);
  problem.pairs = {{.plus = 0}, {.minus = 1, .tangential = 2, .friction_coefficient = 0.25}};
  return problem;
}

TEST(GapWork, IsTheMeanForceTimesTheMotionOfTheWall) {
  const ContactProblem problem = two_contacts();
  ContactState begin = ContactState::unstressed(problem);
  ContactState end = begin;
  begin.normal_force << 10.0, 7.0;
  end.normal_force << 30.0, 9.0;
  end.x << 2e-6, 3e-6, 0.0;
  // Both gaps stay closed: the wall of contact 0 has advanced by 2 um, that of contact 1 has receded by 3 um.
  EXPECT_DOUBLE_EQ(gap_work(problem, begin, end), 20.0 * 2e-6 - 8.0 * 3e-6);
}

TEST(GapWork, AContactThatOnlyOpensTakesNone) {
  const ContactProblem problem = two_contacts();
  ContactState begin = ContactState::unstressed(problem);
  ContactState end = begin;
  begin.normal_force << 10.0, 0.0;
  end.x[0] = 4e-6;
  end.gap[0] = 4e-6;  // the wall stands still: the gap opens by the motion of the foil alone
  EXPECT_EQ(gap_work(problem, begin, end), 0.0);
}

TEST(FrictionDissipation, IsBoundTimesSlipWhateverItsDirection) {
  const ContactProblem problem = two_contacts();
  const Vector begin = Vector::Zero(3);
  Vector end = begin;
  end << 5e-6, 5e-6, -2e-6;
  const Vector p = Eigen::Vector2d(100.0, 8.0);
  EXPECT_DOUBLE_EQ(friction_dissipation(problem, p, begin, end), 0.25 * 8.0 * 2e-6);
  EXPECT_DOUBLE_EQ(friction_dissipation(problem, p, end, begin), 0.25 * 8.0 * 2e-6);
}

}  // namespace
}  // namespace bumpfoil
