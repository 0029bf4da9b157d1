#include "bumpfoil/experiments/cycle/sampled_cycles.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "support/ensemble_cases.hpp"

namespace bumpfoil {
namespace {

using test_support::ensemble_case;

const Distribution ten_micrometres{.kind = DistributionKind::normal, .sigma = 10e-6};

TEST(SampledCycles, StiffnessIsIdentifiedAgain) {
  Case input = ensemble_case({.bump_foil_thickness = Distribution{.kind = DistributionKind::table, .values = {5e-6}}});
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.directions = {0.0};
  cycle.steps = 10;
  Case thicker = input;
  thicker.montecarlo.reset();
  thicker.bump_foil.thickness.values.front() += 5e-6;
  const CycleResult sampled = run_sampled_cycles(sampled_case(input, draw_sample(input, 0))).value();
  EXPECT_EQ(sampled.cycles.at(0).turning_point.value().max_force,
            run_cycles(thicker).cycles.at(0).turning_point.value().max_force);
}

TEST(SampledCycles, QuantitiesAreThoseOfTheFullRecord) {
  Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres}});
  input.settings.get<CycleSettings>().steps = 20;
  for (std::uint64_t i = 0; i < 5; ++i) {
    const Case sampled = sampled_case(input, draw_sample(input, i));
    const CycleResult lean = run_sampled_cycles(sampled).value();
    const CycleResult full = run_cycles(sampled);
    ASSERT_EQ(lean.cycles.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(lean.cycles[k].direction, full.cycles[k].direction);
      EXPECT_EQ(lean.cycles[k].loop_energy, full.cycles[k].loop_energy);
      EXPECT_EQ(lean.cycles[k].loaded_stiffness, full.cycles[k].loaded_stiffness);
      EXPECT_EQ(lean.cycles[k].clearances, full.cycles[k].clearances);
    }
  }
}

/// Independent of samples run before.
TEST(SampledCycles, IsTheSameToTheLastBitAfterOthers) {
  Case input = ensemble_case({.bump_height = HeightScatter{ten_micrometres}});
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.steps = 20;
  cycle.directions.resize(2);
  input.solver.name = SolverName::events;
  SampledCycleRunner runner;
  for (const std::uint64_t number : {4U, 1U, 4U, 2U}) {
    Case sampled = sampled_case(input, draw_sample(input, number));
    if (number == 1) sampled.solver.name = SolverName::newton;
    const CycleResult again = runner.run(sampled);
    const CycleResult alone = run_sampled_cycles(sampled).value();
    EXPECT_EQ(again.solver, alone.solver);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(again.cycles.at(k).loop_energy, alone.cycles.at(k).loop_energy);
      EXPECT_EQ(again.cycles.at(k).clearances, alone.cycles.at(k).clearances);
      EXPECT_EQ(again.cycles.at(k).turning_point.value().max_force, alone.cycles.at(k).turning_point.value().max_force);
    }
  }
}

TEST(SampledCycles, IsNothingWhereWhatWasDrawnMakesNoBearing) {
  const Case input =
      ensemble_case({.friction_top_bump = Distribution{.kind = DistributionKind::table, .values = {-0.2}}});
  const Case sampled = sampled_case(input, draw_sample(input, 0));
  EXPECT_FALSE(run_sampled_cycles(sampled));
  EXPECT_THROW(static_cast<void>(SampledCycleRunner().run(sampled)), Error);
}

}  // namespace
}  // namespace bumpfoil
