#include "bumpfoil/contact/penalty_system.hpp"

#include <gtest/gtest.h>

#include "core/linear_algebra.hpp"
#include "support/dense_contacts.hpp"
#include "support/random_problem.hpp"

namespace bumpfoil {
namespace {

double distance_between(const Vector& a, const Vector& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// Random problems with blocks of fixed sizes and of a generic size.
class PenaltySystemSizes : public testing::TestWithParam<int> {};

TEST_P(PenaltySystemSizes, SolvesLikeDense) {
  const ContactProblem problem = make_random_problem(3, 5, GetParam(), 0.2).problem;
  const DenseContacts dense = make_dense(problem);
  const Vector normal = 1e6 * Vector::LinSpaced(problem.contacts(), 0.0, 3.0);
  const Vector tangential = 1e6 * Vector::LinSpaced(problem.contacts(), 2.0, 0.0);
  const Matrix K = dense.K + dense.normal.transpose() * normal.asDiagonal() * dense.normal +
                   dense.tangential.transpose() * tangential.asDiagonal() * dense.tangential;
  const Vector right = Vector::LinSpaced(K.rows(), -5.0, 9.0);
  const std::unique_ptr<PenaltySystem> system = make_penalty_system(problem);
  ASSERT_TRUE(system->set_stiffness(normal, tangential));
  Vector x = right;
  system->solve_in_place(x);
  const Vector expected = solve(K, right);
  EXPECT_LT(distance_between(x, expected), 1e-11 * expected.cwiseAbs().maxCoeff());
  EXPECT_LT(distance_between(system->multiply(right), dense.K * right),
            1e-14 * (dense.K * right).cwiseAbs().maxCoeff());
}

TEST_P(PenaltySystemSizes, TakesAnotherK) {
  const RandomProblem random = make_random_problem(7, 6, GetParam(), 0.2);
  const ContactProblem other = make_random_problem(8, 6, GetParam(), 0.2).problem;
  const Vector stiffness = Vector::Constant(other.contacts(), 1e7);
  Vector x = random.first.load;
  Vector expected = x;
  const std::unique_ptr<PenaltySystem> penalties = make_penalty_system(random.problem);
  penalties->set_elasticity(other.K);
  ASSERT_TRUE(penalties->set_stiffness(stiffness, stiffness));
  penalties->solve_in_place(x);
  const std::unique_ptr<PenaltySystem> fresh_penalties = make_penalty_system(other);
  ASSERT_TRUE(fresh_penalties->set_stiffness(stiffness, stiffness));
  fresh_penalties->solve_in_place(expected);
  EXPECT_EQ(x, expected);
}

INSTANTIATE_TEST_SUITE_P(BlockSize, PenaltySystemSizes, testing::Values(5, 6, 8, 11));

}  // namespace
}  // namespace bumpfoil
