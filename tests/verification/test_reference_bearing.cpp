#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "support/full_increment.hpp"
/// Known properties of the reference bearing: how much friction stiffens it, where it carries.
namespace bumpfoil {
namespace {

/// With its own identified truss constants.
Case reference_bearing(double friction) {
  Case input = reference_case();
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  return input;
}

class ReferenceBearing : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    smooth = run_cycles(reference_bearing(0.0)).cycles;
    rough = run_cycles(reference_bearing(0.1)).cycles;
  }
  inline static std::vector<Cycle> smooth, rough;  ///< without and with friction: +X, -X, +Y, -Y
};

TEST_F(ReferenceBearing, FrictionRaisesTheLoad) {
  const std::vector<double> percent = {42.0, 42.0, 64.0, 35.0};
  for (std::size_t i = 0; i < percent.size(); ++i) {
    const double ratio = rough[i].turning_point->max_force / smooth[i].turning_point->max_force;
    EXPECT_NEAR(100.0 * (ratio - 1.0), percent[i], 2.0) << "direction " << i;
  }
}

TEST_F(ReferenceBearing, BumpOneCarriesMostTowardsTheWeld) {
  for (const std::vector<Cycle>* cycles : {&smooth, &rough}) {
    const Vector loads = turning_increment((*cycles)[1]).top_bump.normal_force;
    Eigen::Index highest = -1;
    const double largest = loads.maxCoeff(&highest);
    EXPECT_EQ(highest, 0);
    EXPECT_GT(largest, 1.2 * loads.tail(25).maxCoeff());
  }
}

TEST_F(ReferenceBearing, WithoutFrictionTheCrossForceIsSmall) {
  for (const Cycle& cycle : smooth) {
    EXPECT_LT(std::abs(cycle.turning_point->cross_force), 0.02 * cycle.turning_point->max_force);
  }
}

TEST_F(ReferenceBearing, WithoutFrictionThereIsNoLoop) {
  for (const Cycle& cycle : smooth) {
    EXPECT_LT(std::abs(*cycle.loop_energy), 1e-9 * cycle.turns.front().work);
    EXPECT_LT(std::abs(*cycle.loss_factor), 1e-9);
    const double loading = cycle.turning_point->tangent.loading.value();
    EXPECT_NEAR(loading, cycle.turning_point->tangent.unloading.value(), 1e-9 * loading);
  }
}

TEST_F(ReferenceBearing, WithFrictionTheLoopIsClosedAndStickStiffensTheTurn) {
  for (const Cycle& cycle : rough) {
    EXPECT_GT(*cycle.loop_energy, 0.0);
    EXPECT_GT(*cycle.loss_factor, 0.03);
    EXPECT_LT(std::abs(cycle.increments.back().force_direct), 1e-9 * cycle.turning_point->max_force);
    EXPECT_GT(*cycle.turning_point->tangent.unloading, 1.5 * *cycle.turning_point->tangent.loading);
  }
}

}  // namespace
}  // namespace bumpfoil
