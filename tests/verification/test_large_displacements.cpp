#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/bearing_cases.hpp"
#include "support/full_increment.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;

/// Reference bearing with the frame foils, 25 steps per branch.
Case large_frame_case(Geometry geometry, double friction) {
  Case input = reference_case();
  input.bump_foil.model = BumpFoilModel::frame;
  input.bump_foil.geometry = geometry;
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  input.settings.get<CycleSettings>().steps = 25;
  return input;
}

TEST(LargeDisplacements, SoftenTheBearingInEveryDirection) {
  for (const double friction : {0.0, 0.1}) {
    for (const double direction : {0.0, 0.5 * pi, pi, 1.5 * pi}) {
      const Cycle linear = run_single_cycle(large_frame_case(Geometry::linear, friction), direction);
      const Cycle large = run_single_cycle(large_frame_case(Geometry::nonlinear, friction), direction);
      EXPECT_EQ(first_failure(large), "") << direction;
      EXPECT_EQ(large.substeps, 0) << direction;
      ASSERT_TRUE(large.turning_point) << direction;
      // Strips compressed by 20 um soften by 0.65 and 3.8 %; here some bumps are compressed by 47 um, most by less.
      const double softening = 1.0 - large.turning_point->max_force / linear.turning_point->max_force;
      EXPECT_GT(softening, friction > 0.0 ? 0.03 : 0.005) << direction;
      EXPECT_LT(softening, friction > 0.0 ? 0.06 : 0.015) << direction;
      if (friction == 0.0) {
        // Elastic forces have a potential: without friction unloading follows the loading path.
        EXPECT_LT(std::abs(*large.loop_energy), 1e-9 * large.turning_point->elastic_energy) << direction;
      }
    }
  }
}

TEST(LargeDisplacements, VanishWithTheDisplacement) {
  std::vector<double> difference;
  for (const double amplitude : {2e-6, 2e-7}) {
    std::vector<double> force;
    for (const Geometry geometry : {Geometry::linear, Geometry::nonlinear}) {
      Case input = large_frame_case(geometry, 0.1);
      input.bearing.radial_clearance = 0.0;
      input.settings.get<CycleSettings>().amplitude.value = amplitude;
      force.push_back(run_single_cycle(input, 0.0).turning_point->max_force);
    }
    difference.push_back(std::abs(force[1] / force[0] - 1.0));
  }
  EXPECT_LT(difference[0], 0.01);
  EXPECT_NEAR(difference[1], 0.1 * difference[0], 0.03 * difference[0]);  // first order
}

TEST(LargeDisplacements, EnergyBalanceConverges) {
  std::vector<double> defect;
  for (const int steps : {25, 50, 100}) {
    Case input = large_frame_case(Geometry::nonlinear, 0.1);
    input.settings.get<CycleSettings>().steps = steps;
    const Cycle cycle = run_single_cycle(input, 0.0);
    ASSERT_TRUE(cycle.converged());
    const FullIncrement turning = turning_increment(cycle);
    const double stored = turning.elastic_energy - cycle.increments.front().elastic_energy;
    defect.push_back(std::abs(turning.work - stored - turning.dissipated_energy) / turning.work);
  }
  EXPECT_LT(defect[2], 0.01);  // like the linear foils at 100 steps
  // First order: halved with the increment, except for changes of contact.
  EXPECT_LT(defect[1], 0.7 * defect[0]);
  EXPECT_LT(defect[2], 0.7 * defect[1]);
}

TEST(LargeDisplacements, TangentsAreThoseOfTheDeformedFoils) {
  const SharedBearing shared = make_bearing_foils(large_frame_case(Geometry::nonlinear, 0.1));
  const BearingModel& foils = *shared;
  const Eigen::Vector2d n = unit_vector(0.0);
  NewtonSolver solver(foils.problem, {.law_tolerance = 1e-12});
  ContactState state = ContactState::unstressed(foils.problem);
  const auto push = [&](double displacement) {
    const ContactState previous = state;
    EXPECT_TRUE(solver.solve(loading_under(foils, {.position = displacement * n}), previous, state).converged());
    return holding_force(foils, state.normal_force).dot(n);
  };
  double force = 0.0;
  for (int i = 0; i <= 25; ++i) force = push(79.5e-6 * i / 25.0);
  const auto tangents_of = [&](const SharedBearing& of) {
    BearingState where = BearingState::unstressed(foils);
    where.contacts = state;
    return make_stepper(of).tangents(where).along(n);
  };
  const TangentStiffnesses tangents = tangents_of(shared);
  constexpr double step = 1e-10;  // less than to the next event; changes the force by a thousand times its residual
  const double slope = (push(79.5e-6 + step) - force) / step;
  EXPECT_NEAR(slope, tangents.loading.value(), 1e-3 * *tangents.loading);
  // The stiffness of the undeformed foils in the same contact modes is different.
  BearingModel undeformed = foils;
  undeformed.problem.law.reset();
  const double other = tangents_of(std::make_shared<const BearingModel>(undeformed)).loading.value();
  EXPECT_GT(std::abs(other / *tangents.loading - 1.0), 0.02);
}

/// Random scatter, friction and directions.
TEST(LargeDisplacements, AreFollowedInRandomBearings) {
  for (std::uint64_t number = 0; number < 10; ++number) {
    Case input = random_case(number);
    input.bump_foil.model = BumpFoilModel::frame;
    input.bump_foil.geometry = Geometry::nonlinear;
    input.settings.get<CycleSettings>().steps = 25;
    EXPECT_EQ(first_failure(run_single_cycle(input, input.settings.get<CycleSettings>().directions.front())), "")
        << input.title;
  }
}

}  // namespace
}  // namespace bumpfoil
