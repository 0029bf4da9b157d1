#include "bumpfoil/contact/linear_systems.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <vector>

#include "support/dense_contacts.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

double distance(const Vector& a, const Vector& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// A random problem solved for random modes.
struct SolvedForModes {
  SolvedForModes(std::uint64_t seed, int block_size, double friction)
      : random(make_random_problem(seed, 5, block_size, friction)),
        mode(random_modes(seed, random.problem)),
        previous_x(1e-5 * Vector::LinSpaced(random.problem.K.rows(), -1.0, 1.0)),
        system(make_mode_system(random.problem)),
        state(ContactState::unstressed(random.problem)) {
    EXPECT_TRUE(system->set_modes(mode)) << seed;
    system->solve(random.first, previous_x, state);
  }

  RandomProblem random;
  std::vector<ContactMode> mode;
  Vector previous_x;
  std::unique_ptr<ModeSystem> system;
  ContactState state;
};

/// Random problems with blocks of the fixed sizes and of another.
class BlockSizes : public testing::TestWithParam<int> {};

TEST_P(BlockSizes, ModeSystemSolvesLikeDenseMultipliers) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const SolvedForModes solved(seed, GetParam(), seed % 2 == 0 ? 0.3 : 0.0);
    const auto& [random, mode, previous_x, system, state] = solved;
    const DenseState expected = solve_dense(make_dense(random.problem), random.first, previous_x, mode);
    // Condition numbers of some 1e3.
    EXPECT_LT(distance(state.x, expected.x), 1e-11 * expected.x.cwiseAbs().maxCoeff()) << seed;
    EXPECT_LT(distance(state.normal_force, expected.normal_force),
              1e-11 * expected.normal_force.cwiseAbs().maxCoeff() + 1e-12)
        << seed;
    EXPECT_LT(distance(state.friction_force, expected.friction_force),
              1e-11 * expected.normal_force.cwiseAbs().maxCoeff() + 1e-12)
        << seed;
    EXPECT_EQ(state.mode, mode);

    // The state balances what it was solved for.
    ContactLoading balanced;
    system->loading_of(state, balanced);
    EXPECT_LT(distance(balanced.initial_gap, random.first.initial_gap),
              1e-15 * (1.0 + expected.x.cwiseAbs().maxCoeff()))
        << seed;
    EXPECT_LT(distance(balanced.load, random.first.load), 1e-11 * expected.normal_force.cwiseAbs().maxCoeff() + 1e-12)
        << seed;
  }
}

TEST_P(BlockSizes, ModeSystemReusesBlocksThatKeepTheirModes) {
  const RandomProblem random = make_random_problem(7, 6, GetParam(), 0.2);
  const ContactProblem& problem = random.problem;
  const Vector previous_x = Vector::Zero(problem.K.rows());
  const std::unique_ptr<ModeSystem> reused = make_mode_system(problem);
  std::vector<ContactMode> mode = random_modes(1, problem);
  ASSERT_TRUE(reused->set_modes(mode));
  for (const std::size_t contact : {17U, 9U, 0U, 4U}) {
    mode[contact] = mode[contact] == ContactMode::open ? ContactMode::stick : ContactMode::open;
    ASSERT_TRUE(reused->set_modes(mode));
    const std::unique_ptr<ModeSystem> fresh = make_mode_system(problem);
    ASSERT_TRUE(fresh->set_modes(mode));
    ContactState a = ContactState::unstressed(problem);
    ContactState b = a;
    reused->solve(random.first, previous_x, a);
    fresh->solve(random.first, previous_x, b);
    EXPECT_EQ(a.x, b.x);  // the same operations
    EXPECT_EQ(a.normal_force, b.normal_force);
  }
}

TEST_P(BlockSizes, PenaltySystemSolvesLikeDense) {
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
  const Vector expected = K.partialPivLu().solve(right);
  EXPECT_LT(distance(x, expected), 1e-11 * expected.cwiseAbs().maxCoeff());
  EXPECT_LT(distance(system->multiply(right), dense.K * right), 1e-14 * (dense.K * right).cwiseAbs().maxCoeff());
}

/// Contacts in all stages between open, closed, stuck and slipping.
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

TEST_P(BlockSizes, SoftContactSystemSolvesLikeDense) {
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
    const Vector expected = A.partialPivLu().solve(right);
    // Condition numbers of some 1e3 times the ratio of forces and displacements.
    EXPECT_LT(distance(x, expected.head(n)), 1e-11 * expected.head(n).cwiseAbs().maxCoeff());
    const double force = expected.tail(2 * contacts).cwiseAbs().maxCoeff();
    EXPECT_LT(distance(p, expected.segment(n, contacts)), 1e-11 * force);
    EXPECT_LT(distance(t, expected.tail(contacts)), 1e-11 * force);
    const Vector y = Vector::LinSpaced(n, -5.0, 9.0);
    EXPECT_LT(distance(system->multiply(y), dense.K * y), 1e-14 * (dense.K * y).cwiseAbs().maxCoeff());
  }
}

/// With the coefficients of the modes, soft contacts are those of ModeSystem. K dx = x + contact forces is the balance
/// of the whole load where it starts from nothing.
TEST_P(BlockSizes, SoftContactSystemEqualsModeSystemForModes) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const SolvedForModes solved(seed, GetParam(), 0.3);
    const auto& [random, mode, previous_x, exact, state] = solved;
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
    // Condition numbers of some 1e3.
    const double force = state.normal_force.cwiseAbs().maxCoeff() + state.friction_force.cwiseAbs().maxCoeff();
    EXPECT_LT(distance(x, state.x), 1e-11 * state.x.cwiseAbs().maxCoeff()) << seed;
    EXPECT_LT(distance(p, state.normal_force), 1e-11 * force + 1e-12) << seed;
    EXPECT_LT(distance(t, state.friction_force), 1e-11 * force + 1e-12) << seed;
  }
}

TEST_P(BlockSizes, TakeAnotherK) {
  const RandomProblem random = make_random_problem(7, 6, GetParam(), 0.2);
  const ContactProblem other = make_random_problem(8, 6, GetParam(), 0.2).problem;
  const std::vector<ContactMode> mode = random_modes(1, random.problem);
  const Vector previous_x = Vector::Zero(random.problem.K.rows());
  ContactState given = ContactState::unstressed(other);
  ContactState fresh = given;
  const std::unique_ptr<ModeSystem> modes = make_mode_system(random.problem);
  ASSERT_TRUE(modes->set_modes(mode));
  modes->set_elasticity(other.K);
  ASSERT_TRUE(modes->set_modes(mode));
  modes->solve(random.first, previous_x, given);
  const std::unique_ptr<ModeSystem> fresh_modes = make_mode_system(other);
  ASSERT_TRUE(fresh_modes->set_modes(mode));
  fresh_modes->solve(random.first, previous_x, fresh);
  // Constraint rows keep the scale of the first K, which leaves roundings.
  EXPECT_LT(distance(given.x, fresh.x), 1e-11 * fresh.x.cwiseAbs().maxCoeff());
  EXPECT_LT(distance(given.normal_force, fresh.normal_force), 1e-11 * fresh.normal_force.cwiseAbs().maxCoeff());

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

  const std::vector<SoftContact> contacts = soft_contacts(other.contacts());
  Vector p = Vector::Zero(other.contacts());
  Vector t = p;
  x = expected = random.first.load;
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

INSTANTIATE_TEST_SUITE_P(LinearSystems, BlockSizes, testing::Values(5, 6, 8, 11));

TEST(ModeSystem, PrescribesStickByThePreviousState) {
  const ContactProblem block = toy::dragged_block();
  const std::unique_ptr<ModeSystem> system = make_mode_system(block);
  ASSERT_TRUE(system->set_modes({ContactMode::stick}));
  ContactState state = ContactState::unstressed(block);
  system->solve(toy::pull(10.0, 40.0), Eigen::Vector2d(3e-6, 0.0), state);
  EXPECT_DOUBLE_EQ(state.x[0], 3e-6);
  EXPECT_EQ(state.x[1], 0.0);
  EXPECT_DOUBLE_EQ(state.normal_force[0], 40.0);
  EXPECT_DOUBLE_EQ(state.friction_force[0], -4.0);  // spring 6 N less pull 10 N
}

TEST(ModeSystem, MayReturnTensionAndFrictionBeyondTheCone) {
  const ContactProblem block = toy::dragged_block();
  const std::unique_ptr<ModeSystem> system = make_mode_system(block);
  ASSERT_TRUE(system->set_modes({ContactMode::stick}));
  ContactState state = ContactState::unstressed(block);
  system->solve(toy::pull(100.0, -40.0), Vector::Zero(2), state);
  EXPECT_DOUBLE_EQ(state.normal_force[0], -40.0);
  EXPECT_DOUBLE_EQ(state.friction_force[0], -100.0);
}

TEST(ModeSystem, ReportsAMechanism) {
  ContactProblem loose = toy::dragged_block();
  loose.K.diagonal[0](0, 0) = 0.0;  // nothing but friction holds it along the floor
  const std::unique_ptr<ModeSystem> system = make_mode_system(loose);
  EXPECT_TRUE(system->set_modes({ContactMode::stick}));
  EXPECT_FALSE(system->set_modes({ContactMode::open}));
  EXPECT_TRUE(system->set_modes({ContactMode::stick}));  // recovers
}

TEST(ModeSystem, IsLinear) {
  const RandomProblem random = make_random_problem(11, 3, 6, 0.2);
  const std::unique_ptr<ModeSystem> system = make_mode_system(random.problem);
  ASSERT_TRUE(system->set_modes(random_modes(5, random.problem)));
  ContactState once = ContactState::unstressed(random.problem);
  ContactState twice = once;
  const Vector x0 = Vector::Constant(random.problem.K.rows(), 1e-6);
  system->solve(random.first, x0, once);
  const ContactLoading doubled{.initial_gap = 2.0 * random.first.initial_gap, .load = 2.0 * random.first.load};
  system->solve(doubled, 2.0 * x0, twice);
  EXPECT_EQ(twice.x, 2.0 * once.x);  // powers of two are exact
  EXPECT_EQ(twice.normal_force, 2.0 * once.normal_force);
}

}  // namespace
}  // namespace bumpfoil
