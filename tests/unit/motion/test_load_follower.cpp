#include "motion/load_follower.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bumpfoil/bearing/increment.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/motion/load_search.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

constexpr double reach = 0.3e-3;
constexpr double least = 1e-4;  // N
const Eigen::Vector2d first_load(8.0, -60.0);
const Eigen::Vector2d side_load(70.0, -90.0);

class FollowedLoad : public testing::TestWithParam<BumpFoilModel> {
 protected:
  static Case scattered_case() {
    Case input = reference_case();
    input.bump_foil.model = GetParam();
    for (int i = 0; i < input.bump_foil.bumps; ++i) input.bump_foil.height_errors.push_back(4e-6 * std::sin(1.7 * i));
    return input;
  }

  /// From the unstressed foils through the loads, each in this number of equal increments.
  Step through(const std::vector<Eigen::Vector2d>& loads, int increments, SolverName solver = SolverName::events) {
    FoilStepper stepper = make_stepper(foils, {.name = solver, .uzawa = {}});
    Step step, next;
    stepper.assemble({}, step);
    Eigen::Vector2d from(0.0, 0.0);
    for (const Eigen::Vector2d& to : loads) {
      for (int k = 1; k <= increments && step.converged(); ++k) {
        advance_to_load(stepper, step.state, from + (to - from) * k / increments, least, reach, next);
        EXPECT_TRUE(next.converged()) << explanation(next.status);
        EXPECT_EQ(next.is_linear, solver == SolverName::events);
        std::swap(step, next);
      }
      from = to;
    }
    return step;
  }

  [[nodiscard]] Eigen::Vector2d force(const BearingState& at) const {
    return holding_force(*foils, at.contacts.normal_force);
  }

  const SharedBearing foils = make_bearing_foils(scattered_case());
};

TEST_P(FollowedLoad, DoesNotDependOnTheIncrements) {
  const Step once = through({first_load, side_load, first_load}, 1);
  const Step often = through({first_load, side_load, first_load}, 7);
  EXPECT_LT((force(once.state) - first_load).norm(), 1e-7);
  // Loads are met to 1e-9 of their size, with a stiffness of several MN/m.
  EXPECT_LT((once.state.position - often.state.position).norm(), 1e-12);
  EXPECT_NEAR(once.state.work, often.state.work, 1e-8 * once.state.work);
  EXPECT_NEAR(once.state.dissipated_energy, often.state.dissipated_energy, 1e-8 * once.state.work);
  const double largest = once.state.contacts.normal_force.maxCoeff();
  EXPECT_LT((once.state.contacts.normal_force - often.state.contacts.normal_force).cwiseAbs().maxCoeff(),
            1e-7 * largest);
}

TEST_P(FollowedLoad, TurnsRoundWhateverTheIncrements) {
  // Around the bearing, and across its clearance: when the last contacts open, the response is not piecewise linear.
  for (const auto& [back, met] : {std::pair{Eigen::Vector2d(-8.0, 60.0), 1e-12}, {-0.4 * side_load, 1e-9}}) {
    const Step once = through({side_load, back}, 1);
    const Step often = through({side_load, back}, 5);
    EXPECT_LT((force(once.state) - back).norm(), 1e-7);
    EXPECT_LT((once.state.position - often.state.position).norm(), met);
    EXPECT_NEAR(once.state.dissipated_energy, often.state.dissipated_energy, met / 1e-6 * once.state.dissipated_energy);
  }
}

TEST_P(FollowedLoad, KeepsTheEnergyAndTheLine) {
  Step step = through({first_load}, 1);
  FoilStepper stepper = make_stepper(foils, {.name = SolverName::events, .uzawa = {}});
  const BearingState begin = step.state;
  advance_to_load(stepper, begin, side_load, least, reach, step);
  ASSERT_TRUE(step.converged());
  const auto elastic = [&](const BearingState& state) {
    Increment increment;
    check_increment(*foils, state, increment);
    EXPECT_TRUE(increment.residuals.within(1e-9, 1e-12));
    return increment.elastic_energy;
  };
  const double work = step.state.work - begin.work;
  const double dissipated = step.state.dissipated_energy - begin.dissipated_energy;
  EXPECT_NEAR(work, elastic(step.state) - elastic(begin) + dissipated, 1e-9 * work);
  EXPECT_GT(dissipated, 0.01 * work);
  // Between two waypoints the force is on the line from load to load and advances along it.
  ASSERT_GT(step.waypoints.size(), 5U);
  const Eigen::Vector2d line = (side_load - first_load).normalized();
  double gone = 0.0;
  for (const Waypoint& point : step.waypoints) {
    const Eigen::Vector2d more = point.force - first_load;
    EXPECT_LT(std::abs(more.x() * line.y() - more.y() * line.x()), 1e-6);
    EXPECT_GT(more.dot(line), gone - 1e-6);
    gone = more.dot(line);
  }
  EXPECT_LT((step.waypoints.back().position - step.state.position).norm(), 1e-5);
  EXPECT_NE(step.waypoints.back().position, step.state.position);
}

TEST_P(FollowedLoad, IsTheLimitOfManySmallIncrements) {
  const Eigen::Vector2d exact = through({first_load, side_load}, 1).state.position;
  const auto error = [&](int increments) {
    const Step step = through({first_load, side_load}, increments, SolverName::newton);
    return (step.state.position - exact).norm();
  };
  // First order.
  const double coarse = error(10);
  const double fine = error(160);
  EXPECT_LT(fine, 0.15 * coarse);
  EXPECT_LT(fine, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Models, FollowedLoad, testing::Values(BumpFoilModel::truss, BumpFoilModel::frame));

TEST(FollowLoad, SaysWhereNothingDeterminesTheWay) {
  const SharedBearing foils = make_bearing_foils(reference_case());
  FoilStepper stepper = make_stepper(foils, {.name = SolverName::events, .uzawa = {}});
  Step step;
  stepper.assemble({}, step);
  EXPECT_FALSE(follow_load(stepper, {0.0, -5.0}, 1e-9, reach, step));
  EXPECT_EQ(step.state.position, Eigen::Vector2d(0.0, 0.0));
  advance_to_load(stepper, BearingState(step.state), {0.0, -5.0}, least, reach, step);
  ASSERT_TRUE(step.converged());
  EXPECT_FALSE(follow_load(stepper, {0.0, -1e6}, 1e-9, reach, step));
}

TEST(FollowLoad, SaysThatNothingIsInTheWay) {
  Case input = reference_case();
  input.bump_foil.bumps = 9;
  FoilStepper stepper = make_stepper(make_bearing_foils(input), {.name = SolverName::events, .uzawa = {}});
  Step first, step;
  stepper.assemble({}, first);
  // No bump has a normal component along this load, and the journal leaves the bearing.
  advance_to_load(stepper, first.state, 20.0 * unit_vector(3.4), least, reach, step);
  EXPECT_EQ(step.status, Status::load_out_of_reach);
}

TEST(FollowLoad, PutsOneStepBehindAnother) {
  const SharedBearing foils = make_bearing_foils(reference_case());
  Step whole;
  make_stepper(foils, {}).assemble({}, whole);
  Step part = whole;
  whole.substeps = 2;
  whole.cost = {.iterations = 10, .factorisations = 20};
  part.status = Status::load_not_met;
  part.substeps = 3;
  part.cost = {.iterations = 1, .factorisations = 2};
  part.is_linear = !whole.is_linear;
  part.state.position = {1e-6, -2e-6};
  append(*foils, part, whole);
  EXPECT_EQ(whole.status, Status::load_not_met);
  EXPECT_EQ(whole.substeps, 5);
  EXPECT_EQ(whole.cost.iterations, 11);
  EXPECT_EQ(whole.cost.factorisations, 22);
  EXPECT_FALSE(whole.is_linear);
  EXPECT_EQ(whole.state.position, part.state.position);
  ASSERT_EQ(whole.waypoints.size(), 1U);
  EXPECT_EQ(whole.waypoints.front().position, part.state.position);
}

}  // namespace
}  // namespace bumpfoil
