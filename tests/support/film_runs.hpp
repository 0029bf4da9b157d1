#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "support/film_bearing_cases.hpp"
#include "support/film_cases.hpp"

namespace bumpfoil {

/// Expects a run of the prototype on one of its meshes: cold start at 0.7 C_r at most, then along the ray.
inline void expect_run(const ReferenceRun& run, const ReferenceRun::Level& level) {
  SCOPED_TRACE(testing::Message() << run.position.transpose() << ", " << level.resolution.columns_per_pitch << 'x'
                                  << level.resolution.rows);
  const FilmBearing bearing = film_reference_bearing(level.resolution);
  FilmBearingSolver solver(bearing);
  BearingState state;
  const Eigen::Vector2d position = run.position * bearing.clearance;
  ASSERT_EQ(solver.cold_start(std::min(1.0, 0.7 / run.position.norm()) * position, run.speed, state).status,
            FilmStatus::converged);
  ASSERT_EQ(solver.follow(OperatingPoint::held_at(position, run.speed), state).status, FilmStatus::converged);
  const FilmBearingOutcome outcome = film_bearing_outcome(bearing, state);
  // Both solve the same equations on the same mesh, the prototype to 1e-8.
  constexpr double same = 1e-6;
  EXPECT_LT((outcome.force - level.force).norm(), same * std::max(level.force.norm(), 10.0));
  EXPECT_NEAR(outcome.thinnest.thickness * bearing.scales.thickness, level.thinnest, same * level.thinnest);
  EXPECT_NEAR(outcome.max_pressure, level.max_pressure, same * level.max_pressure);
  EXPECT_NEAR(outcome.min_pressure, level.min_pressure, same);
  EXPECT_NEAR(outcome.torque, level.torque, same * std::abs(level.torque));
  EXPECT_NEAR(outcome.power, level.power, same * level.power);
  EXPECT_NEAR(outcome.dissipation, level.dissipation, same * level.dissipation);
  const double flow = std::abs(level.flows.start);
  EXPECT_NEAR(outcome.flows.start, level.flows.start, same * flow);
  EXPECT_NEAR(outcome.flows.end, level.flows.end, same * flow);
  EXPECT_NEAR(outcome.flows.sides, level.flows.sides, same * flow);
  EXPECT_EQ(outcome.loaded_bumps, level.loaded_bumps);
}

}  // namespace bumpfoil
