#include "contact/soft_contact_system.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "bumpfoil/contact/mode_system.hpp"
#include "core/linear_algebra.hpp"
#include "support/dense_contacts.hpp"
#include "support/random_problem.hpp"

namespace bumpfoil {
namespace {

double relative_distance(const Vector& a, const Vector& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// Contacts in all transitions between open, closed, stick and slip.
std::vector<SoftContact> soft_contacts(int contacts) {
  std::vector<SoftContact> soft;
  for (int c = 0; c < contacts; ++c) {
    const double closed = (c % 5) / 4.0;
    const double stuck = (c % 3) / 2.0;
    soft.push_back({.normal_force = 1.0 - closed,
                    .gap = 1e7 * closed,
                    .friction_force = 1.0 - stuck,
                    .coupling = 0.2 * (1.0 - stuck),
                    .slip = 1e7 * stuck});
  }
  return soft;
}

/// Random problems with blocks of fixed sizes and of a generic size.
class SoftContactSystemSizes : public testing::TestWithParam<int> {};

TEST_P(SoftContactSystemSizes, SolvesLikeDense) {
  for (const double friction : {0.2, 0.0}) {
    const ContactProblem problem = make_random_problem(3, 5, GetParam(), friction).problem;
    const DenseContacts dense = make_dense(problem);
    const Eigen::Index n = dense.K.rows();
    const Eigen::Index contacts = problem.contacts();
    const std::vector<SoftContact> soft = soft_contacts(problem.contacts());
    Matrix A = Matrix::Zero(n + 2 * contacts, n + 2 * contacts);
    A.topLeftCorner(n, n) = dense.K;
    A.block(0, n, n, contacts) = -dense.normal.transpose();
    A.topRightCorner(n, contacts) = -dense.tangential.transpose();
    Vector right = Vector::LinSpaced(A.rows(), -5.0, 9.0);
    for (Eigen::Index c = 0; c < contacts; ++c) {
      const SoftContact& s = soft[static_cast<std::size_t>(c)];
      A.row(n + c).head(n) = s.gap * dense.normal.row(c);
      A(n + c, n + c) = s.normal_force;
      const Eigen::Index t = n + contacts + c;
      if (dense.friction[c] == 0.0) {
        A(t, t) = 1.0;
        right[t] = 0.0;
      } else {
        A.row(t).head(n) = s.slip * dense.tangential.row(c);
        A(t, n + c) = s.coupling;
        A(t, t) = s.friction_force;
      }
    }
    Vector x = right.head(n);
    Vector p = right.segment(n, contacts);
    Vector t = right.tail(contacts);
    const std::unique_ptr<SoftContactSystem> system = make_soft_contact_system(problem);
    ASSERT_TRUE(system->set_contacts(soft));
    system->solve_in_place(x, p, t);
    const Vector expected = solve(A, right);
    // Condition numbers of about 1e3 times the ratio of forces and displacements.
    EXPECT_LT(relative_distance(x, expected.head(n)), 1e-11 * expected.head(n).cwiseAbs().maxCoeff());
    const double force = expected.tail(2 * contacts).cwiseAbs().maxCoeff();
    EXPECT_LT(relative_distance(p, expected.segment(n, contacts)), 1e-11 * force);
    EXPECT_LT(relative_distance(t, expected.tail(contacts)), 1e-11 * force);
    const Vector y = Vector::LinSpaced(n, -5.0, 9.0);
    EXPECT_LT(relative_distance(system->multiply(y), dense.K * y), 1e-14 * (dense.K * y).cwiseAbs().maxCoeff());
  }
}

/// With the coefficients of the modes, soft contacts equal those of ModeSystem. K dx = x + contact forces is the
/// balance of the total load, starting from zero.
TEST_P(SoftContactSystemSizes, EqualsModeSystemForModes) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const RandomProblem random = make_random_problem(seed, 5, GetParam(), 0.3);
    const std::vector<ContactMode> mode = random_modes(seed, random.problem);
    const Vector previous_x = 1e-5 * Vector::LinSpaced(random.problem.K.rows(), -1.0, 1.0);
    const std::unique_ptr<ModeSystem> exact = make_mode_system(random.problem);
    ContactState state = ContactState::unstressed(random.problem);
    ASSERT_TRUE(exact->set_modes(mode)) << seed;
    exact->solve(random.first, previous_x, state);
    const ContactProblem& problem = random.problem;
    const Vector previous_slips = tangential_displacements(problem, previous_x);
    constexpr double scale = 1e6;  // N/m, the size of K
    std::vector<SoftContact> soft;
    Vector x = random.first.load;
    Vector p = Vector::Zero(problem.contacts());
    Vector t = p;
    for (Eigen::Index c = 0; c < p.size(); ++c) {
      SoftContact contact;  // open
      const ContactMode m = mode[static_cast<std::size_t>(c)];
      if (m != ContactMode::open) {
        contact.normal_force = 0.0;
        contact.gap = scale;
        p[c] = -scale * random.first.initial_gap[c];
      }
      if (m == ContactMode::stick) {
        contact.friction_force = 0.0;
        contact.slip = scale;
        t[c] = scale * previous_slips[c];
      }
      if (m == ContactMode::slip_forward) contact.coupling = 0.3;
      if (m == ContactMode::slip_backward) contact.coupling = -0.3;
      soft.push_back(contact);
    }
    const std::unique_ptr<SoftContactSystem> system = make_soft_contact_system(problem);
    ASSERT_TRUE(system->set_contacts(soft));
    system->solve_in_place(x, p, t);
    // Condition numbers of about 1e3.
    const double force = state.normal_force.cwiseAbs().maxCoeff() + state.friction_force.cwiseAbs().maxCoeff();
    EXPECT_LT(relative_distance(x, state.x), 1e-11 * state.x.cwiseAbs().maxCoeff()) << seed;
    EXPECT_LT(relative_distance(p, state.normal_force), 1e-11 * force + 1e-12) << seed;
    EXPECT_LT(relative_distance(t, state.friction_force), 1e-11 * force + 1e-12) << seed;
  }
}

TEST_P(SoftContactSystemSizes, TakesAnotherK) {
  const RandomProblem random = make_random_problem(7, 6, GetParam(), 0.2);
  const ContactProblem other = make_random_problem(8, 6, GetParam(), 0.2).problem;
  const std::vector<SoftContact> contacts = soft_contacts(other.contacts());
  Vector p = Vector::Zero(other.contacts());
  Vector t = p;
  Vector x = random.first.load;
  Vector expected = x;
  const std::unique_ptr<SoftContactSystem> soft = make_soft_contact_system(random.problem);
  soft->set_elasticity(other.K);
  ASSERT_TRUE(soft->set_contacts(contacts));
  soft->solve_in_place(x, p, t);
  const std::unique_ptr<SoftContactSystem> fresh_soft = make_soft_contact_system(other);
  ASSERT_TRUE(fresh_soft->set_contacts(contacts));
  p.setZero();
  t.setZero();
  fresh_soft->solve_in_place(expected, p, t);
  EXPECT_EQ(x, expected);
}

INSTANTIATE_TEST_SUITE_P(BlockSize, SoftContactSystemSizes, testing::Values(5, 6, 8, 11, 14, 22, 28));

}  // namespace
}  // namespace bumpfoil
