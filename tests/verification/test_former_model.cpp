#include <gtest/gtest.h>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

/// The present and the Le Lez (2007) model on the reference bearing: docs/theory/former_model.md.
namespace bumpfoil {
namespace {

struct Comparison {
  int direction;  ///< index in the case: +X, -X, +Y, -Y
  double friction;
  double former_force;   ///< N, from the page
  double present_force;  ///< N
};

class FormerAndPresent : public testing::TestWithParam<Comparison> {};

TEST_P(FormerAndPresent, DifferAsThePageSays) {
  const Comparison& expected = GetParam();
  Case input = case_with_given_constants();
  input.friction = {.top_bump = expected.friction, .bump_sleeve = expected.friction};
  input.settings.get<CycleSettings>().directions = {
      input.settings.get<CycleSettings>().directions[static_cast<std::size_t>(expected.direction)]};
  const Cycle present = run_cycles(input).cycles.front();
  input.bump_foil.model = BumpFoilModel::former;
  const Cycle former = run_cycles(input).cycles.front();
  ASSERT_TRUE(present.converged() && former.converged());
  // The page gives one decimal.
  EXPECT_NEAR(former.turning_point->max_force, expected.former_force, 0.06);
  EXPECT_NEAR(present.turning_point->max_force, expected.present_force, 0.06);
  for (const Increment& increment : former.increments) ASSERT_TRUE(increment.residuals.within()) << increment.index;
}

INSTANTIATE_TEST_SUITE_P(Reference, FormerAndPresent,
                         testing::Values(Comparison{0, 0.0, 521.1, 520.7}, Comparison{1, 0.0, 520.1, 537.6},
                                         Comparison{2, 0.0, 519.7, 520.1}, Comparison{3, 0.0, 519.4, 519.8},
                                         Comparison{0, 0.1, 733.1, 739.6}, Comparison{1, 0.1, 731.1, 761.1},
                                         Comparison{2, 0.1, 781.9, 851.5}, Comparison{3, 0.1, 696.1, 703.5}));

TEST(FormerTowardsTheWeld, TheClampedTopFoilCarriesTheDifferenceTowardsTheWeld) {
  Case input = case_with_given_constants();
  input.friction = {};
  input.settings.get<CycleSettings>().directions = {input.settings.get<CycleSettings>().directions[1]};
  const Cycle present = run_cycles(input).cycles.front();
  input.bump_foil.model = BumpFoilModel::former;
  const Cycle former = run_cycles(input).cycles.front();
  const FullIncrement with_foil = turning_increment(present);
  // The part of the journal's load that the crests do not carry goes into the top foil and its weld.
  const double carried = with_foil.journal_top.normal_force.sum() - with_foil.top_bump.normal_force.sum();
  EXPECT_NEAR(carried, 17.0, 3.0);
  EXPECT_NEAR(with_foil.top_bump.normal_force[0], turning_increment(former).top_bump.normal_force[0],
              0.005 * with_foil.top_bump.normal_force[0]);
}

TEST(FormerAcrossTheWeld, FreeCrestsRiseThroughTheJournalWhereThePresentModelLoadsThem) {
  Case input = case_with_given_constants();
  input.settings.get<CycleSettings>().directions = {input.settings.get<CycleSettings>().directions[2]};
  const Cycle present = run_cycles(input).cycles.front();
  input.bump_foil.model = BumpFoilModel::former;
  const Cycle former = run_cycles(input).cycles.front();
  const FullIncrement without = turning_increment(former);
  EXPECT_EQ(without.top_bump.normal_force[1], 0.0);
  EXPECT_LT(without.top_bump.gap[1], -10e-6);
  const Vector loads = turning_increment(present).top_bump.normal_force;
  EXPECT_NEAR(loads[0], 23.0, 0.5);
  EXPECT_NEAR(loads[1], 77.0, 0.6);
  EXPECT_NEAR(loads[2], 118.0, 0.6);
  EXPECT_NEAR(without.top_bump.normal_force[2], 74.0, 0.6);
  EXPECT_NEAR(without.top_bump.normal_force[4] / loads[4], 1.0, 1e-3);
}

}  // namespace
}  // namespace bumpfoil
