#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/experiments/reference_case.hpp"
#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Cases `first` .. `first + 49`: every increment solved within its bounds and none halved.
void expect_all_solved(std::uint64_t first) {
  for (std::uint64_t number = first; number < first + 50; ++number) {
    const Case input = random_case(number);
    const Cycle cycle = run_single_cycle(input, input.settings.get<CycleSettings>().directions.front());
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
    const Cycle cycle = run_single_cycle(input, input.settings.get<CycleSettings>().directions.front());
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

/// A top foil of 29 um over 21 bumps, whose end moves by a nanometre under 2 pN.
Case soft_top_foil() {
  Case input = reference_case();
  input.bearing.radius = 0.028357059467281887;
  input.bearing.axial_length = 0.007077589888747612;
  BumpFoil& foil = input.bump_foil;
  foil.model = BumpFoilModel::frame;
  foil.bumps = 21;
  foil.pitch = 0.0038659338410468496;
  foil.length = 0.0022750081884603045;
  foil.height = 0.0005104030256128851;
  foil.height_reference = HeightReference::midsurface;
  foil.thickness = 0.00014941273792778086;
  foil.youngs_modulus = input.top_foil.youngs_modulus = 39722346167.30298;
  foil.poisson_ratio = input.top_foil.poisson_ratio = 0.27097445824239474;
  foil.sleeve_gaps = std::vector<double>(21, 0.0);
  foil.sleeve_gaps[2] = 3.794491987935492e-05;
  foil.sleeve_gaps[8] = 1.217310627397402e-05;
  foil.sleeve_gaps[13] = 1.54078746089134e-05;
  foil.sleeve_gaps[14] = 3.994419802340246e-06;
  foil.sleeve_gaps[18] = 4.4643205037371915e-06;
  foil.sleeve_gaps[19] = 3.280372337433222e-05;
  input.top_foil.thickness = 2.9388730702553342e-05;
  input.friction.top_bump = input.friction.bump_sleeve = 0.1;
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.5 * std::numbers::pi};
  cycle.amplitude.value = 5.7320151280644255e-05;
  cycle.steps = 10;
  return input;
}

/// Without forces even soft foils return to their manufactured shape: no negligible force holds them.
TEST(RandomBearings, StandFreeOnceTheyAreLetGo) {
  int free = 0;
  for (std::uint64_t number = 0; number < 10; ++number) {
    Case input = number == 0 ? soft_top_foil() : random_foils(number, BumpFoilModel::frame);
    input.solver.name = SolverName::events;
    const Cycle cycle = run_single_cycle(input, input.settings.get<CycleSettings>().directions.front());
    for (Eigen::Index k = 0; k < cycle.fields.increments(); ++k) {
      double force = 0.0;
      for (const InterfaceFields* at : {&cycle.fields.journal_top, &cycle.fields.top_bump, &cycle.fields.bump_sleeve}) {
        force = std::max(force, at->normal_force.row(k).cwiseAbs().maxCoeff());
      }
      if (force > 0.0) continue;
      ++free;
      EXPECT_LT(cycle.fields.top_displacement.row(k).cwiseAbs().maxCoeff(), 1e-13) << input.title << ' ' << k;
    }
  }
  EXPECT_GT(free, 30);
}

/// Under loads, loops are independent of the increments if the journal could be followed all the way. Bearings with
/// interference are excluded: they start at the centre with a holding force, and go straight to the first load.
TEST(RandomBearings, AreFollowedUnderLoads) {
  int followed = 0;
  for (std::uint64_t number = 0; number < 24; ++number) {
    Case input = random_case(number);
    input.solver.name = SolverName::events;
    input.settings.get<CycleSettings>().amplitude = {Control::load, 20.0 + 15.0 * static_cast<double>(number)};
    std::vector<Cycle> cycles;
    for (const int steps : {3, 17}) {
      input.settings.get<CycleSettings>().steps = steps;
      cycles.push_back(run_single_cycle(input, input.settings.get<CycleSettings>().directions.front()));
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
  const auto directions = [] { return random_case(7).settings.get<CycleSettings>().directions; };
  EXPECT_EQ(directions(), directions());
}

}  // namespace
}  // namespace bumpfoil
