#include "bumpfoil/motion/load_search.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

const Eigen::Vector2d push = unit_vector(0.7);
constexpr double search_reach = 0.3e-3;
constexpr double least_load = 1e-6;  // N

/// A bearing that was pushed to 60 um in three increments.
class LoadedBearing : public testing::TestWithParam<SolverName> {
 protected:
  LoadedBearing() {
    Step step;
    stepper.assemble({}, step);
    for (const double s : {40e-6, 50e-6, 60e-6}) {
      state = step.state;
      stepper.advance(state, {.position = s * push}, step);
      EXPECT_TRUE(step.converged());
    }
    state = step.state;
  }

  [[nodiscard]] Eigen::Vector2d force(const BearingState& at) const {
    return holding_force(*foils, at.contacts.normal_force);
  }

  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  FoilStepper stepper = make_stepper(foils, {.name = GetParam(), .uzawa = {}});
  BearingState state;
};

TEST_P(LoadedBearing, FindsALoadWhereMovingThereMeetsIt) {
  // Up, down, across the turning point and to the side: each is one increment from the same state.
  const Eigen::Vector2d now = force(state);
  for (const Eigen::Vector2d& load :
       {Eigen::Vector2d(1.3 * now), Eigen::Vector2d(0.8 * now), Eigen::Vector2d((1.0 - 1e-6) * now),
        Eigen::Vector2d(now + 0.1 * Eigen::Vector2d(-now.y(), now.x()))}) {
    Step by_load, by_place;
    advance_to_load(stepper, state, load, least_load, search_reach, by_load);
    ASSERT_TRUE(by_load.converged()) << load.transpose() << ": " << explanation(by_load.status);
    // The tolerance of the search; the regularised solver has a residual of its own.
    const double met = (GetParam() == SolverName::uzawa ? 1e-5 : 1e-9) * load.norm();
    EXPECT_LT((force(by_load.state) - load).norm(), met);
    if (GetParam() == SolverName::events) continue;  // follows the path with its own increments
    FoilStepper fresh = make_stepper(foils, {.name = GetParam(), .uzawa = {}});
    fresh.advance(state, by_load.state, by_place);
    ASSERT_TRUE(by_place.converged());
    // Both are solved to the same bound, by solvers with different histories: 1e-6 is that of the multipliers.
    const double solved = GetParam() == SolverName::uzawa ? 1e-6 : 1e-9;
    EXPECT_LT((force(by_place.state) - force(by_load.state)).norm(), solved * load.norm());
    EXPECT_NEAR(by_place.state.work, by_load.state.work, solved * std::abs(by_load.state.work));
    EXPECT_NEAR(by_place.state.dissipated_energy, by_load.state.dissipated_energy, solved * by_load.state.work);
  }
}

TEST_P(LoadedBearing, SaysThatALoadIsOutOfReach) {
  Step step;
  advance_to_load(stepper, state, 3.0 * force(state), least_load, 65e-6, step);
  EXPECT_EQ(step.status, Status::load_out_of_reach);
  EXPECT_GT(step.cost.iterations, 0);
}

INSTANTIATE_TEST_SUITE_P(LoadSearch, LoadedBearing,
                         testing::Values(SolverName::newton, SolverName::events, SolverName::uzawa));

TEST(LoadSearch, FindsTheFirstLoadAcrossAnOpenGap) {
  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  FoilStepper stepper = make_stepper(foils);
  Step first, step;
  stepper.assemble({}, first);
  EXPECT_EQ(holding_force(*foils, first.state.contacts.normal_force).norm(), 0.0);  // no force defines the direction
  advance_to_load(stepper, first.state, 5.0 * push, least_load, search_reach, step);
  ASSERT_TRUE(step.converged());
  EXPECT_LT((holding_force(*foils, step.state.contacts.normal_force) - 5.0 * push).norm(), 1e-8);
  EXPECT_GT(step.state.position.norm(), 31.8e-6);
}

TEST(LoadSearch, StandsStillWhereTheLoadIsThere) {
  const SharedBearing foils = make_bearing_foils(case_with_given_constants());
  FoilStepper stepper = make_stepper(foils);
  Step first, loaded, again;
  stepper.assemble({}, first);
  advance_to_load(stepper, first.state, 50.0 * push, least_load, search_reach, loaded);
  ASSERT_TRUE(loaded.converged());
  advance_to_load(stepper, loaded.state, 50.0 * push, least_load, search_reach, again);
  EXPECT_TRUE(again.converged());
  EXPECT_EQ(again.cost, SolveCost{});
  EXPECT_EQ(again.state.position, loaded.state.position);
}

}  // namespace
}  // namespace bumpfoil
