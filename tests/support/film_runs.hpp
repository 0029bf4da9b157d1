#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/motion/branch.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_cases.hpp"

namespace bumpfoil {

/// Checks the equations independently of the solver: the film, the foil with its contact forces, the bump foil, and
/// every inequality of the contacts.
inline void expect_solved(const BearingModel& bearing, const BearingState& state) {
  EXPECT_GT(state.film.pressure.minCoeff(), 0.0);
  EXPECT_GT(state.film.thickness.minCoeff(), 0.0);
  Matrix H = undeformed_thickness(bearing, bearing.film->journal_of(state));
  H += bearing.film->over_the_width(state.film.deflection);
  EXPECT_LT((H - state.film.thickness).cwiseAbs().maxCoeff(), 1e-12);

  const Vector forces = contact_forces(bearing.problem, state.contacts.normal_force, state.contacts.friction_force);
  const int size = bearing.problem.K.block_size();
  Vector elastic = bearing.problem.K.multiply(state.contacts.x);
  for (const FilmPad& pad : bearing.film->pads) {
    const FilmMesh& mesh = pad.foil.mesh;
    FoilFilmState part;
    read_part(pad, state.film, part);
    FoilFilmResidual residual;
    foil_film_residual(pad.foil, film_equation(*bearing.film, pad, state.speed), part, residual);
    const double area = mesh.dtheta * mesh.dzeta;
    EXPECT_LT(mesh.unknown(residual.film).cwiseAbs().maxCoeff(), 1e-9 * area);
    EXPECT_LT(residual.compatibility.cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT(residual.membrane.norm(), 1e-10);

    // The residual of film and foil over the crests is the contact force.
    const double unit = pad.foil.stiffness * bearing.film->scales.thickness;
    elastic.segment((pad.first_block + pad.bumps()) * size, size).setZero();
    for (int i = 0; i < std::ssize(pad.foil.supports); ++i) {
      const int crest = pad.foil.supports[static_cast<std::size_t>(i)];
      for (Eigen::Index s = 0; s < pad.foil.lines.count(); ++s) {
        const Eigen::Index place =
            Eigen::Index{pad.block_of(i)} * size +
            BearingModel::place(bearing.lines, pad.line_over(i, s), bearing.structure.dofs.top_u);
        double& balance = residual.balance(s, crest);
        elastic[place] += balance * unit;
        balance = 0.0;
        EXPECT_NEAR(state.contacts.x[place], part.deflection(s, crest) * bearing.film->scales.thickness, 1e-15);
      }
    }
    EXPECT_LT(residual.balance.cwiseAbs().maxCoeff() * unit, 1e-8);  // N
  }
  const ContactLoading loading{.initial_gap = bearing.assembled_gap, .load = Vector::Zero(forces.size())};
  const ContactResiduals residuals =
      contact_residuals(bearing.problem, elastic, loading, state.slip_origin, state.contacts);
  EXPECT_TRUE(residuals.within(1e-7, 1e-11)) << residuals.equilibrium << ' ' << residuals.penetration;
}

/// Forces and moments by displacements and tilts, N/m: central differences of the force at states a nanometre away.
/// @param state  at `point`
inline JournalMatrix stiffness_by_differences(FilmStepper& stepper, const OperatingPoint& point,
                                              const BearingState& state) {
  constexpr double h = 1e-9;
  JournalMatrix K(4, 4);
  for (Eigen::Index axis = 0; axis < 4; ++axis) {
    JournalVector force[2];
    for (const int side : {0, 1}) {
      BearingState moved = state;
      OperatingPoint there = point;
      double& entry = axis < 2 ? there.journal[axis] : there.tilt.value[axis - 2];
      entry += side == 0 ? -h : h;
      EXPECT_EQ(stepper.advance(there, moved).status, Status::converged);
      force[side] = journal_force(stepper.film(), moved.film, point.speed);
    }
    K.col(axis) = (force[1] - force[0]) / (2.0 * h);
  }
  return K;
}

/// Checks that the linearised equations have this stiffness, and that the slowest motion has a small residual in the
/// equations of all unknowns.
inline void expect_stiffness_of_differences(FilmStepper& stepper, const OperatingPoint& point,
                                            const BearingState& state) {
  const JournalMatrix K = stiffness_by_differences(stepper, point, state);
  const auto motion = stepper.slow_motion(state);
  ASSERT_TRUE(motion.has_value());
  ASSERT_EQ(motion->stiffness.rows(), 4);
  EXPECT_LT((motion->stiffness - K).colwise().norm().maxCoeff(), 3e-6 * K.norm());
  EXPECT_TRUE(stepper.held_motion(state).has_value());  // its residual in the equations of all unknowns is small
}

/// Checks a run of the prototype on one of its meshes: started from ambient pressure at most at 0.7 C_r, then along the
/// ray.
inline void expect_run(const ReferenceRun& run, const ReferenceRun::Level& level) {
  SCOPED_TRACE(testing::Message() << run.position.transpose() << ", " << level.resolution.columns_per_pitch << 'x'
                                  << level.resolution.rows);
  const BearingModel bearing = film_reference_bearing(level.resolution);
  FilmStepper stepper(bearing);
  BearingState state;
  const Eigen::Vector2d position = run.position * bearing.clearance;
  ASSERT_EQ(start_from_ambient(stepper, std::min(1.0, 0.7 / run.position.norm()) * position, run.speed, state).status,
            Status::converged);
  ASSERT_EQ(follow(stepper, OperatingPoint::held_at(position, run.speed), state).status, Status::converged);
  const FilmBearingOutcome outcome = film_bearing_outcome(bearing, state);
  // Both solve the same equations on the same mesh, the prototype to 1e-8.
  constexpr double same = 1e-6;
  EXPECT_LT((outcome.force - level.force).norm(), same * std::max(level.force.norm(), 10.0));
  EXPECT_NEAR(outcome.thinnest.thickness * bearing.film->scales.thickness, level.thinnest, same * level.thinnest);
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
