#include "bumpfoil/contact/newton.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <ostream>

#include "bumpfoil/contact/residual.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// Solver and state of a problem that is loaded step by step.
struct LoadPath {
  explicit LoadPath(const ContactProblem& p, const NewtonOptions& options = {})
      : problem(p), solver(p, options), state(ContactState::unstressed(p)) {}

  void load(const ContactLoading& loading) {
    const ContactState previous = state;
    report = solver.solve(loading, previous, state);
    ASSERT_TRUE(report.converged());
    const Vector elastic = problem.law ? problem.law->forces(state.x) : problem.K.multiply(state.x);
    EXPECT_TRUE(contact_residuals(problem, elastic, loading, previous.x, state).within());
    EXPECT_LT((state.gap - contact_gaps(problem, loading.initial_gap, state.x)).cwiseAbs().maxCoeff(), 1e-18);
  }

  ContactProblem problem;
  NewtonSolver solver;
  ContactState state;
  SolveReport report;
};

/// One of the three methods at a time; modes that need no change are taken by the first.
struct Method {
  const char* name;
  NewtonOptions options;
};
void PrintTo(const Method& method, std::ostream* out) {
  *out << method.name;
}
const Method mode_updates{"mode_updates", {.max_mode_updates = 12}};
const Method event_path{"event_path", {.max_mode_updates = 0, .max_events = 1000}};
const Method interior_point{"interior_point", {.max_mode_updates = 0, .max_events = 0}};

class Toys : public testing::TestWithParam<Method> {
 protected:
  [[nodiscard]] static NewtonOptions options() { return GetParam().options; }
};

TEST_P(Toys, SpringAgainstAWall) {
  LoadPath run(toy::spring_against_a_wall(), options());
  const auto push = [](double load) {
    return ContactLoading{.initial_gap = Vector::Constant(1, 1e-5), .load = Vector::Constant(1, load)};
  };
  run.load(push(5.0));  // 5 um of 10
  EXPECT_DOUBLE_EQ(run.state.x[0], 5e-6);
  EXPECT_EQ(run.state.normal_force[0], 0.0);
  EXPECT_EQ(run.state.mode[0], ContactMode::open);
  run.load(push(25.0));  // the spring holds 10 N, the wall the rest
  EXPECT_DOUBLE_EQ(run.state.x[0], 1e-5);
  EXPECT_NEAR(run.state.normal_force[0], 15.0, 1e-13);
  EXPECT_EQ(run.state.mode[0], ContactMode::stick);
  run.load(push(-5.0));
  EXPECT_DOUBLE_EQ(run.state.x[0], -5e-6);
  EXPECT_EQ(run.state.normal_force[0], 0.0);
}

TEST_P(Toys, WallPushedIntoTheSpring) {
  LoadPath run(toy::spring_against_a_wall(), options());
  run.load({.initial_gap = Vector::Constant(1, -2e-5), .load = Vector::Zero(1)});
  EXPECT_DOUBLE_EQ(run.state.x[0], -2e-5);
  EXPECT_DOUBLE_EQ(run.state.normal_force[0], 20.0);
}

/// Pressed by 40 N the floor holds 20 N; the spring along it has 2 N/um.
TEST_P(Toys, BlockDraggedForthAndBack) {
  LoadPath run(toy::dragged_block(), options());
  const auto expect = [&](double pull, double micrometres, double friction, ContactMode mode) {
    run.load(toy::pull(pull, 40.0));
    EXPECT_NEAR(run.state.x[0], 1e-6 * micrometres, 1e-18) << "pulled by " << pull;
    EXPECT_NEAR(run.state.friction_force[0], friction, 1e-12) << "pulled by " << pull;
    EXPECT_NEAR(run.state.normal_force[0], 40.0, 1e-12);
    EXPECT_EQ(run.state.mode[0], mode) << "pulled by " << pull;
  };
  expect(15.0, 0.0, -15.0, ContactMode::stick);
  expect(30.0, 5.0, -20.0, ContactMode::slip_forward);
  expect(40.0, 10.0, -20.0, ContactMode::slip_forward);
  expect(10.0, 10.0, 10.0, ContactMode::stick);  // the spring pulls back with 20 N
  expect(-10.0, 5.0, 20.0, ContactMode::slip_backward);
  expect(-30.0, -5.0, 20.0, ContactMode::slip_backward);
  expect(0.0, -5.0, -10.0, ContactMode::stick);
}

TEST_P(Toys, BlockLetGoForgetsItsFriction) {
  LoadPath run(toy::dragged_block(), options());
  run.load(toy::pull(30.0, 40.0));
  run.load(toy::pull(30.0, -5.0));
  EXPECT_EQ(run.state.mode[0], ContactMode::open);
  EXPECT_DOUBLE_EQ(run.state.x[0], 15e-6);
  EXPECT_DOUBLE_EQ(run.state.x[1], 5e-6);
  EXPECT_EQ(run.state.friction_force[0], 0.0);
  run.load(toy::pull(30.0, 40.0));  // lands where it hung: held there without friction
  EXPECT_DOUBLE_EQ(run.state.x[0], 15e-6);
  EXPECT_NEAR(run.state.friction_force[0], 0.0, 1e-12);
}

/// Two springs against walls, not coupled. The load on the first just reaches its wall: gap and force are both zero,
/// and either mode is right. The second has to change, so that every method looks at both.
TEST_P(Toys, TouchingContactKeepsItsMode) {
  ContactProblem problem = toy::spring_against_a_wall();
  problem.K = BlockTridiagonal(2, 1);
  problem.sites = in_every_block(problem.sites, 2);
  problem.K.add(0, 0, 0, 0, 1e6);
  problem.K.add(1, 0, 1, 0, 3e6);
  const auto push = [](double first, double second) {
    return ContactLoading{.initial_gap = Vector::Constant(2, 1e-5), .load = Eigen::Vector2d(first, second)};
  };
  for (const double before : {4.0, 25.0}) {  // open, pressed
    for (const double second : {70.0, 31.0}) {
      LoadPath run(problem, options());
      run.load(push(before, 3.0));
      const ContactMode mode = run.state.mode[0];
      EXPECT_EQ(mode, before < 10.0 ? ContactMode::open : ContactMode::stick);
      run.load(push(10.0, second));
      EXPECT_EQ(run.state.mode[0], mode) << "from " << before << " N, the other to " << second << " N";
      EXPECT_EQ(run.state.mode[1], ContactMode::stick);
    }
  }
}

/// Both slabs pressed down by 30 N onto beds of 1 N/um; the floor is 10 um below, the slabs 4 um apart.
TEST_P(Toys, StackedSlabs) {
  LoadPath run(toy::stacked_slabs(), options());
  const Vector gaps = Eigen::Vector2d(10e-6, 4e-6);
  run.load({.initial_gap = gaps, .load = Eigen::Vector2d(-3.0, -6.0)});  // hang free: 7 um and 1 um left
  EXPECT_EQ(run.state.normal_force, Vector::Zero(2));
  run.load({.initial_gap = gaps, .load = Eigen::Vector2d(-3.0, -11.0)});  // the upper rests on the lower
  // Together: x0 + x1 = -14 um and x1 = x0 - 4 um.
  EXPECT_NEAR(run.state.x[0], -5e-6, 1e-18);
  EXPECT_NEAR(run.state.x[1], -9e-6, 1e-18);
  EXPECT_NEAR(run.state.normal_force[1], 2.0, 1e-12);
  EXPECT_EQ(run.state.normal_force[0], 0.0);
  run.load({.initial_gap = gaps, .load = Eigen::Vector2d(-30.0, -30.0)});  // and both on the floor
  EXPECT_NEAR(run.state.normal_force[1], 16.0, 1e-12);
  EXPECT_NEAR(run.state.normal_force[0], 36.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(NewtonSolver, Toys, testing::Values(mode_updates, event_path, interior_point),
                         [](const testing::TestParamInfo<Method>& which) { return which.param.name; });

TEST(NewtonSolver, ResultDoesNotDependOnTheMethod) {
  int followed = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const RandomProblem random = (seed % 3 == 2 ? make_irregular_problem : make_random_problem)(seed, 20, 6, 0.3);
    const ContactState start = ContactState::unstressed(random.problem);
    ContactState state, other;
    NewtonSolver solver(random.problem, {.max_mode_updates = 100});
    ASSERT_TRUE(solver.solve(random.first, start, state).converged()) << seed;
    for (const Method* method : {&event_path, &interior_point}) {
      NewtonSolver by_method(random.problem, method->options);
      const SolveReport report = by_method.solve(random.first, start, other);
      ASSERT_TRUE(report.converged()) << seed << method->name;
      if (method == &interior_point) {
        EXPECT_GT(report.cost.outer_iterations, 0) << seed;
      } else if (report.cost.outer_iterations == 0) {
        ++followed;
      }
      EXPECT_LT((other.x - state.x).norm(), 1e-11 * state.x.norm()) << seed << method->name;
      EXPECT_LT((other.normal_force - state.normal_force).norm(), 1e-11 * state.normal_force.norm()) << seed;
      EXPECT_LT((other.friction_force - state.friction_force).norm(), 1e-11 * state.normal_force.norm()) << seed;
    }
  }
  EXPECT_GE(followed, 55);  // paths may end early: friction is not monotone
}

/// A film adds unsymmetric parts to K, other ones at every step.
TEST(NewtonSolver, TakesAnotherMatrixThatIsNotSymmetric) {
  for (const int size : {5, 14, 22}) {
    RandomProblem random = make_random_problem(7, 6, size, 0.2);
    NewtonSolver solver(random.problem);
    const ContactState unstressed = ContactState::unstressed(random.problem);
    ContactState state;
    ASSERT_TRUE(solver.solve(random.first, unstressed, state).converged());
    BlockTridiagonal& K = random.problem.K;
    for (const Matrix& block : K.upper) K.lower.push_back(0.95 * block.transpose());
    K.diagonal[2](0, 4) += 1e5;
    solver.set_elasticity(K);
    ASSERT_TRUE(solver.solve(random.first, unstressed, state).converged()) << size;
    const ContactResiduals residuals =
        contact_residuals(random.problem, K.multiply(state.x), random.first, unstressed.x, state);
    EXPECT_TRUE(residuals.within()) << size;
  }
}

TEST(NewtonSolver, KeepsNoMemoryBetweenSolves) {
  const RandomProblem random = make_random_problem(5, 4, 6, 0.2);
  LoadPath once(random.problem);
  once.load(random.first);
  LoadPath twice(random.problem);
  ContactState scratch;
  (void)twice.solver.solve(random.second, twice.state, scratch);
  twice.load(random.first);
  EXPECT_LT((once.state.x - twice.state.x).norm(), 1e-13 * once.state.x.norm());
  EXPECT_EQ(once.state.mode, twice.state.mode);
}

TEST(NewtonSolver, ResultMayOverwriteWhatItIsGiven) {
  const RandomProblem random = make_random_problem(6, 3, 6, 0.2);
  NewtonSolver solver(random.problem);
  const ContactState start = ContactState::unstressed(random.problem);
  ContactState clean;
  ASSERT_TRUE(solver.solve(random.first, start, clean).converged());
  ContactState poisoned{.x = Vector::Constant(99, std::numeric_limits<double>::quiet_NaN()),
                        .gap = {},
                        .normal_force = Vector::Constant(1, std::numeric_limits<double>::infinity()),
                        .friction_force = {},
                        .mode = {ContactMode::slip_backward}};
  ASSERT_TRUE(solver.solve(random.first, start, poisoned).converged());
  EXPECT_EQ(poisoned.x, clean.x);
  EXPECT_EQ(poisoned.gap, clean.gap);
  EXPECT_EQ(poisoned.normal_force, clean.normal_force);
}

TEST(NewtonSolver, FailsOnWhatIsNotANumberAndRecovers) {
  const RandomProblem random = make_random_problem(8, 6, 6, 0.3);
  ContactLoading broken = random.first;
  broken.initial_gap[3] = std::numeric_limits<double>::quiet_NaN();
  NewtonSolver solver(random.problem);
  ContactState state;
  EXPECT_FALSE(solver.solve(broken, ContactState::unstressed(random.problem), state).converged());
  EXPECT_TRUE(solver.solve(random.first, ContactState::unstressed(random.problem), state).converged());
}

/// Friction coefficient 1 in strongly coupled problems: modes cycle and paths end, so that the last of the three
/// methods has to do it. Without that method the solver must say that it failed.
TEST(NewtonSolver, InteriorPointSolvesWhatIsLeft) {
  int left = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const RandomProblem random = make_random_problem(seed, 20, 6, 1.0);
    const ContactState start = ContactState::unstressed(random.problem);
    ContactState state;
    const auto solved = [&] {
      return contact_residuals(random.problem, random.problem.K.multiply(state.x), random.first, start.x, state)
          .within();
    };
    NewtonSolver crippled(random.problem, {.max_events = 1000, .max_interior_steps = 0});
    if (crippled.solve(random.first, start, state).converged()) {
      EXPECT_TRUE(solved()) << seed;
      continue;
    }
    ++left;
    NewtonSolver solver(random.problem);
    const SolveReport report = solver.solve(random.first, start, state);
    EXPECT_TRUE(report.converged()) << seed;
    EXPECT_GE(report.cost.outer_iterations, 1) << seed;
    EXPECT_TRUE(solved()) << seed;
  }
  EXPECT_GE(left, 5);  // 10 when this was written; which they are depends on roundings
}

/// The dragged block on a spring that hardens: 2e6 x (1 + (x / 10 um)^2) along the floor.
TEST(NewtonSolver, MeetsAHardeningSpring) {
  ContactProblem problem = toy::dragged_block();
  problem.law = ElasticLaw{
      .forces = [](const Vector& x) { return Eigen::Vector2d(2e6 * x[0] * (1.0 + 1e10 * x[0] * x[0]), 1e6 * x[1]); },
      .tangent =
          [](const Vector& x) {
            BlockTridiagonal K(1, 2);
            K.add(0, 0, 0, 0, 2e6 * (1.0 + 3e10 * x[0] * x[0]));
            K.add(0, 1, 0, 1, 1e6);
            return K;
          },
      .stable_tangent = nullptr};  // not needed here
  LoadPath run(problem);
  run.load(toy::pull(0.0, 40.0));
  run.load(toy::pull(60.0, 40.0));  // 20 N of friction, 40 N of spring: 20 z (1 + z^2) = 40 at z = 1
  EXPECT_NEAR(run.state.x[0], 1e-5, 1e-15);
  EXPECT_NEAR(run.state.friction_force[0], -20.0, 1e-12);
  EXPECT_EQ(run.state.mode[0], ContactMode::slip_forward);
  EXPECT_LE(run.report.cost.iterations, 8);  // quadratic once the block slips
  run.load(toy::pull(30.0, 40.0));           // holds: the spring pulls back with 10 N
  EXPECT_EQ(run.state.mode[0], ContactMode::stick);
  EXPECT_NEAR(run.state.friction_force[0], 10.0, 1e-9);
  run.load(toy::pull(0.0, 40.0));  // 20 N hold: z (1 + z^2) = 1
  EXPECT_NEAR(run.state.x[0], 0.6823278038280194e-5, 1e-15);
  EXPECT_EQ(run.state.mode[0], ContactMode::slip_backward);
}

/// A shallow arch with one unknown, e = c x (x - a) (x - 2a), pressed beyond its limit load of 0.385 c a^3 against a
/// wall behind it. The tangent does not lead there: it is negative between the limit points.
TEST(NewtonSolver, SnapsToWhereTheFoilIsHeld) {
  constexpr double a = 1e-5;
  constexpr double c = 1e6 / (2.0 * a * a);
  const auto scalar = [](double k) {
    BlockTridiagonal K(1, 1);
    K.add(0, 0, 0, 0, k);
    return K;
  };
  ContactProblem problem = toy::spring_against_a_wall();
  problem.law = ElasticLaw{
      .forces = [](const Vector& x) { return Vector::Constant(1, c * x[0] * (x[0] - a) * (x[0] - 2.0 * a)); },
      .tangent = [&](const Vector& x) { return scalar(c * (3.0 * x[0] * x[0] - 6.0 * a * x[0] + 2.0 * a * a)); },
      .stable_tangent = [&](const Vector&) { return scalar(1e6); }};
  for (const double wall : {1.5 * a, 3.0 * a}) {
    LoadPath run(problem);
    const auto push = [wall](double load) {
      return ContactLoading{.initial_gap = Vector::Constant(1, wall),
                            .load = Vector::Constant(1, load * c * a * a * a)};
    };
    run.load(push(0.38));
    EXPECT_LT(run.state.x[0], 0.43 * a);  // short of the limit point at 1 - 1/sqrt(3)
    run.load(push(0.5));
    if (wall < 2.0 * a) {
      EXPECT_DOUBLE_EQ(run.state.x[0], wall);
      EXPECT_NEAR(run.state.normal_force[0], (0.5 + 0.375) * c * a * a * a, 1e-9);
    } else {
      EXPECT_NEAR(run.state.x[0], 2.1914878840 * a, 1e-9 * a);  // root of z (z - 1) (z - 2) = 1/2
      EXPECT_EQ(run.state.mode[0], ContactMode::open);
    }
  }
}

TEST(NewtonSolver, TakesALinearLawForItsMatrix) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    RandomProblem random = make_random_problem(seed, 5, 6, 0.2);
    LoadPath plain(random.problem);
    const BlockTridiagonal K = random.problem.K;
    const auto tangent = [K](const Vector&) { return K; };
    random.problem.K = BlockTridiagonal(5, 6);  // must not be used
    random.problem.K.diagonal.assign(5, 1e6 * Matrix::Identity(6, 6));
    random.problem.law = ElasticLaw{
        .forces = [K](const Vector& x) { return K.multiply(x); }, .tangent = tangent, .stable_tangent = tangent};
    LoadPath lawful(random.problem);
    for (const ContactLoading& loading : {random.first, random.second}) {
      plain.load(loading);
      lawful.load(loading);
      // Condition numbers of some 1e3.
      EXPECT_LT((lawful.state.x - plain.state.x).norm(), 1e-11 * plain.state.x.norm()) << seed;
      EXPECT_EQ(lawful.state.mode, plain.state.mode) << seed;
    }
  }
}

TEST(NewtonSolver, SaysThatALawWasNotMet) {
  ContactProblem problem = toy::spring_against_a_wall();
  const auto tangent = [](const Vector&) { return toy::spring_against_a_wall().K; };
  problem.law = ElasticLaw{.forces = [](const Vector& x) { return Vector::Constant(1, x[0] > 0.0 ? 5.0 : -5.0); },
                           .tangent = tangent,
                           .stable_tangent = tangent};
  NewtonSolver solver(problem);
  const ContactLoading loading{.initial_gap = Vector::Constant(1, 1.0), .load = Vector::Zero(1)};
  ContactState state;
  EXPECT_FALSE(solver.solve(loading, ContactState::unstressed(problem), state).converged());
  problem.law->forces = [](const Vector&) { return Vector::Constant(1, std::numeric_limits<double>::quiet_NaN()); };
  NewtonSolver without_numbers(problem);
  EXPECT_FALSE(without_numbers.solve(loading, ContactState::unstressed(problem), state).converged());
}

/// Thirty blocks land at once, five of them pulled. These are held, as the pull is below the friction bound, but are
/// first tried slipping. All contradict their modes at first, only five after one round; the thirty determine the
/// expected number of events.
TEST(NewtonSolver, FollowsEventsOnlyWhereFewContactsContradictAtFirst) {
  constexpr int blocks = 30;
  ContactProblem problem = toy::dragged_block();
  problem.K = BlockTridiagonal(blocks, 2);
  problem.sites = in_every_block(problem.sites, blocks);
  ContactLoading loading{.initial_gap = Vector::Zero(blocks), .load = Vector::Zero(2 * blocks)};
  for (int block = 0; block < blocks; ++block) {
    problem.K.add(block, 0, block, 0, 2e6);
    problem.K.add(block, 1, block, 1, 1e6);
    loading.load[2 * block] = block < 5 ? 15.0 : 0.0;
    loading.load[2 * block + 1] = -40.0;
  }
  for (const int max_events : {20, 30}) {
    LoadPath run(problem, {.max_mode_updates = 1, .max_events = max_events});
    run.load(loading);
    EXPECT_EQ(run.report.cost.outer_iterations == 0, max_events == 30);
    EXPECT_NEAR(run.state.friction_force[0], -15.0, 1e-12);
  }
}

/// Nothing but friction holds the block along the floor: the modes of the last increment, open, leave a mechanism.
TEST(NewtonSolver, LeavesAMechanismBehind) {
  ContactProblem loose = toy::dragged_block();
  loose.K.diagonal[0](0, 0) = 0.0;
  LoadPath run(loose);
  run.load(toy::pull(15.0, 40.0));
  EXPECT_EQ(run.state.mode[0], ContactMode::stick);
  EXPECT_NEAR(run.state.friction_force[0], -15.0, 1e-12);
}

/// An unconstrained unknown: every factorisation fails, and no solve can follow.
TEST(NewtonSolver, CountsNoSolvesOfSingularSystems) {
  ContactProblem loose = toy::dragged_block();
  loose.K.diagonal[0](0, 0) = 0.0;
  loose.sites[0].tangential = -1;
  NewtonSolver solver(loose);
  ContactState state;
  const SolveReport report = solver.solve(toy::pull(15.0, 40.0), ContactState::unstressed(loose), state);
  EXPECT_FALSE(report.converged());
  EXPECT_EQ(report.cost.iterations, 0);
  EXPECT_GE(report.cost.factorisations, 4);  // the modes, and the interior point from each of its three starts
}

#ifdef BUMPFOIL_ASSERTIONS
TEST(NewtonSolver, NeedsContacts) {
  ContactProblem bare = toy::dragged_block();
  bare.sites.clear();
  EXPECT_DEATH(NewtonSolver{bare}, "contacts\\(\\) > 0");
}
#endif

TEST(NewtonSolver, CountsWhatItDid) {
  LoadPath run(toy::dragged_block());
  run.load(toy::pull(15.0, 40.0));
  EXPECT_GE(run.report.cost.iterations, 1);
  EXPECT_LE(run.report.cost.iterations, 3);
  EXPECT_EQ(run.report.cost.outer_iterations, 0);
}

}  // namespace
}  // namespace bumpfoil
