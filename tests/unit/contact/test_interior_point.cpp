#include "contact/interior_point.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "support/random_problem.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

TEST(ComplementaryPair, MeetsItsProductToFirstOrder) {
  ComplementaryPair pair{.force = 3.0, .length = 2e-6};
  pair.aim(1e-6, false);
  pair.length_step = 1e-6;
  pair.take_force_from_length();
  EXPECT_DOUBLE_EQ(pair.force_step, (1e-6 - 6e-6 - 3e-6) / 2e-6);
  const double force_step = pair.force_step;
  pair.take_length_from_force();
  EXPECT_DOUBLE_EQ(pair.length_step, 1e-6);
  // With the second-order part of the last step taken off.
  pair.aim(1e-6, true);
  EXPECT_NEAR(pair.deficit, -5e-6 - force_step * 1e-6, 1e-20);
}

TEST(ComplementaryPair, StaysPositive) {
  ComplementaryPair pair{.force = 3.0, .length = 2e-6, .force_step = -6.0, .length_step = -8e-6};
  EXPECT_DOUBLE_EQ(pair.longest(1.0), 0.25);
  EXPECT_DOUBLE_EQ(pair.longest(0.1), 0.1);
  EXPECT_DOUBLE_EQ(pair.product(0.25), 0.0);
  pair.length_step = 8e-6;
  EXPECT_DOUBLE_EQ(pair.longest(1.0), 0.5);
  pair.take(0.25);
  EXPECT_DOUBLE_EQ(pair.force, 1.5);
  EXPECT_DOUBLE_EQ(pair.length, 4e-6);
}

/// Relative changes of force and length add up to -1: what takes clearly more than half of it vanishes.
TEST(ComplementaryPair, TellsWhatVanishes) {
  const auto trend = [](double force_change) {
    return ComplementaryPair{.force = 3.0, .length = 2e-6, .force_step = 3.0 * force_change}.trend();
  };
  EXPECT_EQ(trend(-1.0), 1);
  EXPECT_EQ(trend(-0.61), 1);
  EXPECT_EQ(trend(-0.59), 0);
  EXPECT_EQ(trend(-0.5), 0);
  EXPECT_EQ(trend(-0.41), 0);
  EXPECT_EQ(trend(-0.39), -1);
  EXPECT_EQ(trend(0.0), -1);
}

/// Steps until the modes rest three times in a row, at most 100.
int steps_to_rest(InteriorPoint& interior) {
  int resting = 0;
  for (int steps = 1; steps <= 100; ++steps) {
    const bool moves = interior.step();
    resting = interior.changed_modes() == 0 ? resting + 1 : 0;
    if (resting == 3 || !moves) return steps;
  }
  return 100;
}

TEST(InteriorPoint, FindsTheModesOfADraggedBlock) {
  const ContactProblem problem = toy::dragged_block();
  const ContactState start = ContactState::unstressed(problem);
  InteriorPoint interior(problem);
  const auto mode = [&](double along, double down) {
    interior.start(toy::pull(along, down), start, 1.0, 0.995);
    EXPECT_LE(steps_to_rest(interior), 20);
    return interior.modes().front();
  };
  // Friction holds 20 N.
  EXPECT_EQ(mode(15.0, 40.0), ContactMode::stick);
  EXPECT_EQ(mode(-15.0, 40.0), ContactMode::stick);
  EXPECT_EQ(mode(30.0, 40.0), ContactMode::slip_forward);
  EXPECT_EQ(mode(-30.0, 40.0), ContactMode::slip_backward);
  EXPECT_EQ(mode(30.0, -5.0), ContactMode::open);
}

/// The load just reaches the wall, or the bound of friction: either of two modes is right, and the former stays.
TEST(InteriorPoint, KeepsTheModeOfContactsThatMayHaveEither) {
  const auto rest = [](const ContactProblem& problem, const ContactLoading& loading, ContactMode mode) {
    ContactState previous = ContactState::unstressed(problem);
    previous.mode = {mode};
    InteriorPoint interior(problem);
    interior.start(loading, previous, 1.0, 0.995);
    for (int step = 0; step < 12; ++step) (void)interior.step();
    return interior.modes().front();
  };
  const ContactLoading touching{.initial_gap = Vector::Constant(1, 1e-5), .load = Vector::Constant(1, 10.0)};
  for (const ContactMode mode : {ContactMode::open, ContactMode::stick}) {
    EXPECT_EQ(rest(toy::spring_against_a_wall(), touching, mode), mode);
  }
  for (const ContactMode mode : {ContactMode::slip_forward, ContactMode::stick}) {
    EXPECT_EQ(rest(toy::dragged_block(), toy::pull(20.0, 40.0), mode), mode);
  }
}

/// A state that fits its loading exactly leaves no length to start with.
TEST(InteriorPoint, StartsFromASolution) {
  const ContactProblem problem = toy::dragged_block();
  ContactState solution = ContactState::unstressed(problem);
  solution.normal_force[0] = 40.0;
  solution.friction_force[0] = -15.0;
  solution.mode = {ContactMode::slip_backward};  // but for its mode
  InteriorPoint interior(problem);
  interior.start(toy::pull(15.0, 40.0), solution, 1.0, 0.995);
  EXPECT_TRUE(interior.step());
  EXPECT_LE(steps_to_rest(interior), 20);
  EXPECT_EQ(interior.modes().front(), ContactMode::stick);
}

TEST(InteriorPoint, RemembersNothing) {
  const ContactProblem problem = toy::dragged_block();
  const ContactState start = ContactState::unstressed(problem);
  InteriorPoint interior(problem);
  interior.start(toy::pull(30.0, 40.0), start, 1.0, 0.995);
  EXPECT_TRUE(interior.step());
  EXPECT_EQ(interior.changed_modes(), 1);
  interior.start(toy::pull(30.0, 40.0), start, 1.0, 0.995);
  EXPECT_EQ(interior.changed_modes(), 0);
  EXPECT_EQ(interior.modes(), start.mode);
}

TEST(InteriorPoint, CountsItsSolves) {
  ContactProblem problem = toy::dragged_block();
  InteriorPoint interior(problem);
  interior.start(toy::pull(30.0, 40.0), ContactState::unstressed(problem), 1.0, 0.995);
  EXPECT_TRUE(interior.step());
  EXPECT_EQ(interior.solves(), 2);
  problem.K.diagonal[0](0, 0) = 0.0;  // only friction holds the block along the floor
  problem.sites[0].tangential = -1;
  InteriorPoint loose(problem);
  loose.start(toy::pull(30.0, 40.0), ContactState::unstressed(problem), 1.0, 0.995);
  EXPECT_FALSE(loose.step());
  EXPECT_EQ(loose.solves(), 0);
}

/// Steps until the exact solution for the modes passes the residual, at most 100.
int steps_to_solution(const RandomProblem& random) {
  const ContactState start = ContactState::unstressed(random.problem);
  const std::unique_ptr<ModeSystem> exact = make_mode_system(random.problem);
  ContactState state;
  InteriorPoint interior(random.problem);
  interior.start(random.first, start, 1.0, 0.995);
  for (int steps = 1; steps < 100; ++steps) {
    if (!interior.step()) break;
    if (!exact->set_modes(interior.modes())) continue;
    exact->solve(random.first, start.x, state);
    const Vector elastic_force = random.problem.K.multiply(state.x);
    if (contact_residuals(random.problem, elastic_force, random.first, start.x, state).within()) return steps;
  }
  return 100;
}

TEST(InteriorPoint, TakesHardlyMoreStepsForMoreContacts) {
  for (const int blocks : {10, 100, 1000}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      EXPECT_LE(steps_to_solution(make_random_problem(seed, blocks, 6, 0.3)), 20) << blocks << " blocks, seed " << seed;
    }
  }
}

/// Initial slips scale with the inverse of friction. Tiny friction takes a few more steps: the slip direction stays
/// undecided for longer.
TEST(InteriorPoint, TakesHardlyMoreStepsForTinyFriction) {
  for (const double friction : {0.1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      EXPECT_LE(steps_to_solution(make_random_problem(seed, 20, 6, friction)), 20) << friction << ", seed " << seed;
    }
  }
}

/// Nothing in the start has a scale of its own: loads and gaps a million times smaller take as many steps.
TEST(InteriorPoint, TakesAsManyStepsForSmallLoads) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomProblem random = make_random_problem(seed, 20, 6, 0.3);
    const auto steps_to_rest_of_modes = [&] {
      InteriorPoint interior(random.problem);
      interior.start(random.first, ContactState::unstressed(random.problem), 1.0, 0.995);
      return steps_to_rest(interior);
    };
    const int steps = steps_to_rest_of_modes();
    random.first.initial_gap *= 0x1p-20;  // powers of two are exact
    random.first.load *= 0x1p-20;
    EXPECT_EQ(steps_to_rest_of_modes(), steps) << seed;
  }
}

TEST(InteriorPoint, TakesAnotherK) {
  const RandomProblem random = make_random_problem(1, 10, 6, 0.2);
  RandomProblem other = make_random_problem(2, 10, 6, 0.2);
  const ContactState start = ContactState::unstressed(random.problem);
  InteriorPoint given(random.problem);
  given.set_elasticity(other.problem.K);
  InteriorPoint fresh(other.problem);
  for (InteriorPoint* interior : {&given, &fresh}) {
    interior->start(other.first, start, 1.0, 0.995);
    EXPECT_LE(steps_to_rest(*interior), 25);
  }
  EXPECT_EQ(given.modes(), fresh.modes());
}

TEST(InteriorPoint, EndsOnWhatIsNotANumber) {
  const RandomProblem random = make_random_problem(1, 3, 6, 0.2);
  ContactLoading broken = random.first;
  broken.load[2] = std::numeric_limits<double>::quiet_NaN();
  InteriorPoint interior(random.problem);
  interior.start(broken, ContactState::unstressed(random.problem), 1.0, 0.995);
  EXPECT_FALSE(interior.step());
}

}  // namespace
}  // namespace bumpfoil
