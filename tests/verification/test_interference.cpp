#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "support/bearing_cases.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

/// Clearances of any sign and heights that bridge them: the foils may be compressed before the journal moves.
namespace bumpfoil {
namespace {

Case with_clearance(double clearance, double friction) {
  Case input = case_with_given_constants();
  input.bearing.radial_clearance = clearance;
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  input.settings.get<CycleSettings>().steps = 40;
  return input;
}

TEST(Interference, ClearancesOfAnySignAreSolved) {
  for (const double clearance : {-10e-6, -1e-6, 0.0, 1e-6, 20e-6, 50e-6}) {
    for (const double friction : {0.0, 0.1}) {
      for (const double direction : {0.0, 2.0, 4.0}) {
        const Cycle cycle = run_single_cycle(with_clearance(clearance, friction), direction);
        ASSERT_EQ(first_failure(cycle), "") << clearance << ' ' << friction << ' ' << direction;
        EXPECT_EQ(cycle.substeps, 0);
        const FullIncrement assembly = increment_at(cycle, 0);
        if (clearance < 0.0) {
          EXPECT_GT(cycle.initial_journal_load, 1.0);
          EXPECT_GT(assembly.elastic_energy, 1e-8);
          EXPECT_GE(assembly.top_displacement.minCoeff(), -clearance - 1e-12);  // out of the journal's way
          EXPECT_EQ(cycle.first_contact, 0.0);
          EXPECT_EQ(cycle.assembly_dissipation > 0.0, friction > 0.0);
        } else {
          EXPECT_EQ(cycle.initial_journal_load, 0.0);
          EXPECT_EQ(assembly.elastic_energy, 0.0);
          EXPECT_EQ(cycle.assembly_dissipation, 0.0);
          // The nearest crest is within half a pitch of the direction, 6.9 degrees, or behind the weld: 8.1 degrees.
          EXPECT_GE(*cycle.first_contact, clearance);
          EXPECT_LE(*cycle.first_contact, 1.01 * clearance);
        }
        EXPECT_EQ(assembly.work, 0.0);
        EXPECT_EQ(assembly.dissipated_energy, 0.0);
      }
    }
  }
}

TEST(Interference, TighterBearingsAreStifferAndHoldMore) {
  double last_load = -1.0;
  double last_force = 0.0;
  for (const double clearance : {50e-6, 20e-6, 0.0, -5e-6, -10e-6}) {
    const Cycle cycle = run_single_cycle(with_clearance(clearance, 0.1), 0.0);
    EXPECT_GE(cycle.initial_journal_load, std::max(0.0, last_load));
    EXPECT_GT(cycle.turning_point->max_force, last_force);
    last_load = cycle.initial_journal_load;
    last_force = cycle.turning_point->max_force;
  }
  EXPECT_GT(last_load, 100.0);
}

/// Without friction the foils are elastic: closing the clearance uniformly does the work of the sum of journal loads,
/// dE0/dC_r = -sum of p.
TEST(Interference, JournalLoadsAreTheDerivativeOfTheAssemblyEnergy) {
  constexpr double step = 1e-9;
  const auto assembly = [](double clearance) {
    Case input = with_clearance(clearance, 0.0);
    input.bump_foil.height_errors = reference_cycles().back().input.bump_foil.height_errors;
    input.settings.get<CycleSettings>().steps = 1;
    return run_single_cycle(input, 0.0);
  };
  for (const double clearance : {-10e-6, -3e-6, 2e-6}) {
    const double slope = (assembly(clearance + step).increments.front().elastic_energy -
                          assembly(clearance - step).increments.front().elastic_energy) /
                         (2.0 * step);
    const double load = assembly(clearance).initial_journal_load;
    EXPECT_GT(load, 1.0);
    EXPECT_NEAR(-slope, load, 1e-5 * load);  // energies of 1e-4 J differenced over 1e-9 m; there may be a kink between
  }
}

TEST(Interference, HeightsBeyondTheClearanceSqueezeTheCentredJournal) {
  Case input = case_with_given_constants();
  input.settings.get<CycleSettings>().steps = 40;
  std::vector<double>& errors = input.bump_foil.height_errors;
  errors.assign(26, 0.0);
  errors[5] = 60e-6;
  errors[12] = -20e-6;
  errors[18] = 50e-6;
  const Cycle cycle = run_single_cycle(input, 1.0);
  ASSERT_EQ(first_failure(cycle), "");
  const FullIncrement assembly = increment_at(cycle, 0);
  EXPECT_GT(cycle.initial_journal_load, 10.0);
  EXPECT_GT(assembly.elastic_energy, 0.0);
  EXPECT_GT(cycle.assembly_dissipation, 0.0);
  EXPECT_GT(std::hypot(assembly.force_x, assembly.force_y), 1.0);
  // The tall bumps carry the journal, their neighbours do not touch it.
  EXPECT_GT(assembly.top_bump.normal_force[5], assembly.top_bump.normal_force[18]);
  EXPECT_GT(assembly.top_bump.normal_force[18], 1.0);
  EXPECT_EQ(assembly.top_bump.normal_force[12], 0.0);
  EXPECT_GT(assembly.top_bump.gap[12], 0.0);
}

TEST(Interference, SleeveGapsMustCloseBeforeBumpsCarry) {
  Case input = case_with_given_constants();
  const double plain = run_single_cycle(input, 0.0).turning_point->max_force;
  input.bump_foil.sleeve_gaps.assign(26, 5e-6);
  const Cycle cycle = run_single_cycle(input, 0.0);
  ASSERT_EQ(first_failure(cycle), "");
  EXPECT_LT(cycle.turning_point->max_force, plain);
  EXPECT_DOUBLE_EQ(increment_at(cycle, 0).bump_sleeve.gap[10], 5e-6);
  // Loaded feet have closed their gap.
  const FullIncrement turning = turning_increment(cycle);
  for (Eigen::Index i = 0; i < 26; ++i) {
    if (turning.bump_sleeve.normal_force[i] > 0.0) {
      EXPECT_NEAR(turning.foot_v[i], 5e-6, 1e-12);
    }
  }
}

}  // namespace
}  // namespace bumpfoil
