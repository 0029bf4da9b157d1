#include "bumpfoil/contact/mode_system.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "support/dense_contacts.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

double distance(const Vector& a, const Vector& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// Random problems with blocks of the fixed sizes and of another.
class ModeSystemSizes : public testing::TestWithParam<int> {};

/// Answers to unit changes add up to the answer to a loading.
TEST_P(ModeSystemSizes, UnitAnswersAddUp) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto make = seed % 4 > 1 ? make_irregular_problem : make_random_problem;
    const RandomProblem random = make(seed, 5, GetParam(), seed % 2 == 0 ? 0.3 : 0.0);
    const ContactProblem& problem = random.problem;
    const std::vector<ContactMode> mode = random_modes(seed, problem);
    const std::unique_ptr<ModeSystem> system = make_mode_system(problem);
    ASSERT_TRUE(system->set_modes(mode));
    RowMajorMatrix x, force;
    system->solve_units(x, force);

    // A change of each coordinate, as a loading and as a combination of columns.
    ContactLoading loading = ContactLoading::none(problem);
    Vector previous_x = Vector::Zero(problem.K.rows());
    std::vector<double> changes;
    for_each_contact(problem, [&](const CoulombContact& contact) {
      const ContactMode m = mode[static_cast<std::size_t>(contact.index)];
      const double change = 1.0 + static_cast<double>(contact.index);
      changes.push_back(m == ContactMode::open ? change : 1e-6 * change);
      if (m == ContactMode::open) {
        contact.add_forces(change, 0.0, 1.0, loading.load);
      } else {
        loading.initial_gap[contact.index] = -1e-6 * change;
      }
      if (contact.f == 0.0) return;
      changes.push_back(m == ContactMode::stick ? 2e-6 * change : -change);
      if (m == ContactMode::stick) {
        previous_x[contact.row + contact.site.tangential] = 2e-6 * change;
      } else {
        loading.load[contact.row + contact.site.tangential] -= change;
      }
    });
    ASSERT_EQ(x.cols(), std::ssize(changes));
    const Vector sizes = Eigen::Map<const Vector>(changes.data(), std::ssize(changes));
    ContactState state;
    system->solve(loading, previous_x, state);
    EXPECT_LT(distance(x * sizes, state.x), 1e-11 * state.x.cwiseAbs().maxCoeff()) << seed;
    const Vector forces = force * sizes;
    const double tolerance = 1e-10 * state.normal_force.cwiseAbs().maxCoeff() + 1e-9;
    Eigen::Index row = 0;
    for_each_contact(problem, [&](const CoulombContact& contact) {
      EXPECT_NEAR(forces[row++], state.normal_force[contact.index], tolerance) << seed;
      if (contact.f == 0.0) return;
      EXPECT_NEAR(forces[row++], state.friction_force[contact.index], tolerance) << seed;
    });
  }
}

TEST_P(ModeSystemSizes, SolvesLikeDenseMultipliers) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto make = seed % 4 > 1 ? make_irregular_problem : make_random_problem;
    const RandomProblem random = make(seed, 5, GetParam(), seed % 2 == 0 ? 0.3 : 0.0);
    const std::vector<ContactMode> mode = random_modes(seed, random.problem);
    const Vector previous_x = 1e-5 * Vector::LinSpaced(random.problem.K.rows(), -1.0, 1.0);
    const std::unique_ptr<ModeSystem> system = make_mode_system(random.problem);
    ContactState state = ContactState::unstressed(random.problem);
    ASSERT_TRUE(system->set_modes(mode)) << seed;
    system->solve(random.first, previous_x, state);
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

    // The state is in balance with the loading of the solve.
    ContactLoading balanced;
    system->loading_of(state, balanced);
    EXPECT_LT(distance(balanced.initial_gap, random.first.initial_gap),
              1e-15 * (1.0 + expected.x.cwiseAbs().maxCoeff()))
        << seed;
    EXPECT_LT(distance(balanced.load, random.first.load), 1e-11 * expected.normal_force.cwiseAbs().maxCoeff() + 1e-12)
        << seed;
  }
}

TEST_P(ModeSystemSizes, ReusesBlocksThatKeepTheirModes) {
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

TEST_P(ModeSystemSizes, TakesAnotherK) {
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
  // Constraint rows keep the scale of the first K: differences are round-off.
  EXPECT_LT(distance(given.x, fresh.x), 1e-11 * fresh.x.cwiseAbs().maxCoeff());
  EXPECT_LT(distance(given.normal_force, fresh.normal_force), 1e-11 * fresh.normal_force.cwiseAbs().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(BlockSize, ModeSystemSizes, testing::Values(5, 6, 8, 11, 14, 22, 28));

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
  loose.K.diagonal[0](0, 0) = 0.0;  // only friction holds it along the floor
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
