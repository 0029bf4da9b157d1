#include "contact/interior_point.hpp"

#include <gtest/gtest.h>

#include <limits>

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
  pair.advance(0.25);
  EXPECT_DOUBLE_EQ(pair.force, 1.5);
  EXPECT_DOUBLE_EQ(pair.length, 4e-6);
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
