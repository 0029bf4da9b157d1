#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Cases `first` .. `first + 49`: every increment solved within its bounds and none halved.
void expect_all_solved(std::uint64_t first) {
  for (std::uint64_t number = first; number < first + 50; ++number) {
    const Case input = random_case(number);
    const Cycle cycle = run_single_cycle(input, input.cycle.directions.front());
    EXPECT_EQ(first_failure(cycle), "") << input.title;
    EXPECT_EQ(cycle.substeps, 0) << input.title;
  }
}

// Two hundred cases in four tests that run side by side.
TEST(RandomBearings, AreSolvedFirstQuarter) {
  expect_all_solved(0);
}
TEST(RandomBearings, AreSolvedSecondQuarter) {
  expect_all_solved(50);
}
TEST(RandomBearings, AreSolvedThirdQuarter) {
  expect_all_solved(100);
}
TEST(RandomBearings, AreSolvedFourthQuarter) {
  expect_all_solved(150);
}

/// Followed event by event, too, without a single small increment in the response: the plain energy balance, work
/// equals energy stored and dissipated, holds at every increment.
TEST(RandomBearings, AreFollowedFromEventToEvent) {
  for (std::uint64_t number = 0; number < 100; ++number) {
    Case input = random_case(number);
    input.solver.name = SolverName::events;
    const Cycle cycle = run_single_cycle(input, input.cycle.directions.front());
    ASSERT_EQ(first_failure(cycle), "") << input.title;
    EXPECT_EQ(cycle.substeps, 0) << input.title;
    double largest_work = 0.0;
    double imbalance = 0.0;
    for (const Increment& k : cycle.increments) {
      const double stored = k.elastic_energy - cycle.increments.front().elastic_energy;
      largest_work = std::max(largest_work, std::abs(k.work));
      imbalance = std::max(imbalance, std::abs(k.work - stored - k.dissipated_energy));
    }
    EXPECT_LE(imbalance, 1e-9 * largest_work) << input.title;  // sums of some thousand pieces with roundings of 1e-16
  }
}

/// Under loads, too: where the journal could be followed all the way, loops do not depend on the increments. Bearings
/// that are squeezed when the journal is centred are left out: their way begins with the force that holds it there, and
/// goes straight to the first load that is asked for.
TEST(RandomBearings, AreFollowedUnderLoads) {
  int followed = 0;
  for (std::uint64_t number = 0; number < 24; ++number) {
    Case input = random_case(number);
    input.solver.name = SolverName::events;
    input.cycle.amplitude = {Control::load, 20.0 + 15.0 * static_cast<double>(number)};
    std::vector<Cycle> cycles;
    for (const int steps : {3, 17}) {
      input.cycle.steps = steps;
      cycles.push_back(run_single_cycle(input, input.cycle.directions.front()));
      EXPECT_EQ(first_failure(cycles.back()), "") << input.title;
      ASSERT_TRUE(cycles.back().loop_energy) << input.title;
    }
    const bool squeezed = cycles[0].initial_journal_load > 0.0;
    if (squeezed || cycles[0].substeps > 0 || cycles[1].substeps > 0) continue;
    ++followed;
    const double work = cycles[0].turns.front().work;
    EXPECT_NEAR(*cycles[0].loop_energy, *cycles[1].loop_energy, 1e-8 * work) << input.title;
  }
  EXPECT_GE(followed, 6);
}

TEST(RandomBearings, AreTheSameForTheSameNumberAndDifferOtherwise) {
  EXPECT_EQ(random_case(7).bump_foil.height_errors, random_case(7).bump_foil.height_errors);
  EXPECT_NE(random_case(7).bump_foil.height_errors, random_case(8).bump_foil.height_errors);
  EXPECT_EQ(random_case(7).cycle.directions, random_case(7).cycle.directions);
}

}  // namespace
}  // namespace bumpfoil
