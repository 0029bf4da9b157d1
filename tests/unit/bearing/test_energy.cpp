#include "bumpfoil/bearing/energy.hpp"

#include <gtest/gtest.h>

#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// One unknown against a wall, and one slipping contact.
ContactProblem two_contacts() {
  ContactProblem problem;
  problem.K = BlockTridiagonal(1, 3);
  problem.sites = {{.plus = 0}, {.minus = 1, .tangential = 2, .friction_coefficient = 0.25}};
  return problem;
}

TEST(GapWork, IsTheMeanForceTimesTheMotionOfTheWall) {
  // The wall of contact 0 advances by 2 um, that of contact 1 recedes by 3 um, that of contact 2 is fixed.
  const Vector force = Eigen::Vector3d(20.0, 8.0, 5.0);
  EXPECT_DOUBLE_EQ(gap_work(force, Eigen::Vector3d(-2e-6, 3e-6, 0.0)), 20.0 * 2e-6 - 8.0 * 3e-6);
}

TEST(FrictionWork, IsTheMeanForceTimesTheSlipAgainstIt) {
  const ContactProblem problem = two_contacts();
  ContactState begin = ContactState::unstressed(problem);
  ContactState end = begin;
  end.x[2] = -2e-6;
  begin.friction_force[1] = 1.0;
  end.friction_force[1] = 3.0;
  EXPECT_DOUBLE_EQ(friction_work(problem, begin, end), 2.0 * 2e-6);
  EXPECT_DOUBLE_EQ(friction_work(problem, end, begin), -2.0 * 2e-6);
}

TEST(FrictionDissipation, IsBoundTimesSlipWhateverItsDirection) {
  const FrictionDissipation dissipation(two_contacts());
  const Vector begin = Vector::Zero(3);
  Vector end = begin;
  end << 5e-6, 5e-6, -2e-6;
  const Vector p = Eigen::Vector2d(100.0, 8.0);
  EXPECT_DOUBLE_EQ(dissipation.of(p, begin, end), 0.25 * 8.0 * 2e-6);
  EXPECT_DOUBLE_EQ(dissipation.of(p, end, begin), 0.25 * 8.0 * 2e-6);
}

TEST(FrictionDissipation, KnowsBlocksThatDifferInTheirContacts) {
  ContactProblem problem;
  problem.K = BlockTridiagonal(3, 2);
  problem.sites = {{.block = 0, .minus = 0, .tangential = 1, .friction_coefficient = 0.5},
                   {.block = 2, .plus = 0},
                   {.block = 2, .minus = 0, .tangential = 1, .friction_coefficient = 0.25}};
  const Vector begin = Vector::Zero(6);
  Vector end = begin;
  end[1] = 1e-6;
  end[5] = -3e-6;
  EXPECT_DOUBLE_EQ(FrictionDissipation(problem).of(Eigen::Vector3d(4.0, 100.0, 8.0), begin, end),
                   0.5 * 4.0 * 1e-6 + 0.25 * 8.0 * 3e-6);
}

}  // namespace
}  // namespace bumpfoil
