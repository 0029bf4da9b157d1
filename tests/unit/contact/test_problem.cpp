#include "bumpfoil/contact/problem.hpp"

#include <gtest/gtest.h>

#include "support/dense_contacts.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

TEST(ContactProblem, CountsContactsOfAllBlocks) {
  const ContactProblem problem = make_random_problem(1, 4, 6, 0.1).problem;
  EXPECT_EQ(problem.contacts(), 12);
}

TEST(ContactProblem, UnstressedFoilsHaveNoForces) {
  const ContactProblem problem = make_random_problem(1, 4, 6, 0.1).problem;
  const ContactState state = ContactState::unstressed(problem);
  EXPECT_EQ(state.x, Vector::Zero(24));
  EXPECT_EQ(state.gap, Vector::Zero(12));
  EXPECT_EQ(state.normal_force, Vector::Zero(12));
  EXPECT_EQ(state.friction_force, Vector::Zero(12));
  EXPECT_EQ(state.mode.size(), 12U);
}

TEST(ContactProblem, GapsOpenWithPlusAndCloseWithMinus) {
  const ContactProblem slabs = toy::stacked_slabs();
  const Vector gap = contact_gaps(slabs, Eigen::Vector2d(10.0, 20.0), Eigen::Vector2d(1.0, 5.0));
  EXPECT_EQ(gap, Eigen::Vector2d(11.0, 24.0));
  EXPECT_EQ(contact_gaps(toy::spring_against_a_wall(), Vector::Constant(1, 3.0), Vector::Constant(1, 4.0))[0], -1.0);
}

TEST(ContactProblem, ForcesPushApartAndFrictionActsAlong) {
  const ContactProblem slabs = toy::stacked_slabs();
  EXPECT_EQ(contact_forces(slabs, Eigen::Vector2d(7.0, 2.0), Vector::Zero(2)), Eigen::Vector2d(5.0, 2.0));
  const ContactProblem block = toy::dragged_block();
  EXPECT_EQ(contact_forces(block, Vector::Constant(1, 8.0), Vector::Constant(1, -3.0)), Eigen::Vector2d(-3.0, 8.0));
}

TEST(ContactProblem, TangentialDisplacementsAreZeroWhereFrictionless) {
  EXPECT_EQ(tangential_displacements(toy::dragged_block(), Eigen::Vector2d(4.0, 9.0)), Vector::Constant(1, 4.0));
  EXPECT_EQ(tangential_displacements(toy::stacked_slabs(), Eigen::Vector2d(4.0, 9.0)), Vector::Zero(2));
}

TEST(ContactProblem, GapsAndForcesAreTransposesOfEachOther) {
  const ContactProblem problem = make_random_problem(2, 3, 7, 0.1).problem;
  const DenseContacts dense = make_dense(problem);
  const Vector p = Vector::LinSpaced(problem.contacts(), 1.0, 9.0);
  const Vector t = Vector::LinSpaced(problem.contacts(), -4.0, 4.0);
  const Vector x = Vector::LinSpaced(problem.K.rows(), -1.0, 2.0);
  const Vector force = dense.normal.transpose() * p + dense.tangential.transpose() * t;
  const Vector gap = p + dense.normal * x;
  EXPECT_LT((contact_forces(problem, p, t) - force).norm(), 1e-15 * force.norm());  // sums in a different order
  EXPECT_LT((contact_gaps(problem, p, x) - gap).norm(), 1e-15 * gap.norm());
}

/// 1 N as in residuals, but less for problems with smaller forces.
TEST(ContactProblem, ReferenceForcesAreNoLargerThanItsOwn) {
  ContactProblem problem = toy::spring_against_a_wall();
  problem.force_scale = 300.0;
  EXPECT_DOUBLE_EQ(problem.least_reference_force(), 1.0);
  problem.force_scale = 3e-3;
  EXPECT_DOUBLE_EQ(problem.least_reference_force(), 3e-4);
}

}  // namespace
}  // namespace bumpfoil
