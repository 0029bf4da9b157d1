#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/bearing_cases.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

/// Results must not depend on the side from which the bearing is viewed, the unit of force, or time spent at rest.
namespace bumpfoil {
namespace {

using std::numbers::pi;

Case rough_bearing() {
  Case input = reference_cycles().back().input;  // the one with height errors
  input.settings.get<CycleSettings>().steps = 50;
  return input;
}

/// Fields of one increment, all interfaces one after the other.
Vector normal_forces(const FullIncrement& increment) {
  Vector all(increment.journal_top.normal_force.size() + increment.top_bump.normal_force.size() +
             increment.bump_sleeve.normal_force.size());
  all << increment.journal_top.normal_force, increment.top_bump.normal_force, increment.bump_sleeve.normal_force;
  return all;
}

void expect_same_modes(const FullIncrement& a, const FullIncrement& b) {
  EXPECT_EQ(a.journal_top.mode, b.journal_top.mode) << "increment " << a.index;
  EXPECT_EQ(a.top_bump.mode, b.top_bump.mode) << "increment " << a.index;
  EXPECT_EQ(a.bump_sleeve.mode, b.bump_sleeve.mode) << "increment " << a.index;
}

TEST(Symmetry, MirroredBearingAnswersMirrored) {
  // About the X axis angles change sign; about the Y axis they become pi - angle.
  for (const double axis : {0.0, 0.5 * pi}) {
    for (const double direction : {0.0, 0.6, 2.0, 0.5 * pi, 4.5}) {
      Case input = rough_bearing();
      input.bearing.weld_angle = 2.7;
      const Cycle cycle = run_single_cycle(input, direction);
      input.bearing.weld_angle = 2.0 * axis - input.bearing.weld_angle;
      input.bearing.wrap = Wrap::counterclockwise;
      const Cycle mirrored = run_single_cycle(input, 2.0 * axis - direction);
      ASSERT_TRUE(cycle.converged() && mirrored.converged());
      const double largest = cycle.turning_point->max_force;
      for (std::size_t k = 0; k < cycle.increments.size(); ++k) {
        const FullIncrement a = increment_at(cycle, static_cast<int>(k));
        const FullIncrement b = increment_at(mirrored, static_cast<int>(k));
        // Angles of a few radians are accurate to 1e-15, gaps to 1e-19 m; stiffnesses reach 1e8 N/m.
        ASSERT_NEAR(a.force_direct, b.force_direct, 1e-10 * largest);
        ASSERT_NEAR(a.force_cross, -b.force_cross, 1e-10 * largest);
        ASSERT_LT((normal_forces(a) - normal_forces(b)).cwiseAbs().maxCoeff(), 1e-10 * largest);
        expect_same_modes(a, b);
      }
    }
  }
}

TEST(Symmetry, TurningBearingAndDirectionTogetherTurnsTheAnswer) {
  Case input = rough_bearing();
  const Cycle cycle = run_single_cycle(input, 0.3);
  constexpr double turn = 1.1;
  input.bearing.weld_angle += turn;
  const Cycle turned = run_single_cycle(input, 0.3 + turn);
  const double largest = cycle.turning_point->max_force;
  for (std::size_t k = 0; k < cycle.increments.size(); ++k) {
    ASSERT_NEAR(cycle.increments[k].force_direct, turned.increments[k].force_direct, 1e-10 * largest);
    ASSERT_NEAR(cycle.increments[k].force_cross, turned.increments[k].force_cross, 1e-10 * largest);
  }
}

TEST(Symmetry, TenTimesStifferFoilsAnswerWithTenTimesTheForce) {
  const Case input = rough_bearing();
  Case stiff = input;
  stiff.bump_foil.youngs_modulus *= 10.0;
  stiff.top_foil.youngs_modulus *= 10.0;
  TrussOverrides& truss = stiff.bump_foil.truss;
  for (std::optional<double>* k : {&truss.k1, &truss.k2, &truss.k3, &truss.k4}) *k = 10.0 * **k;
  for (const double direction : {0.0, pi, 1.0}) {
    const Cycle soft_cycle = run_single_cycle(input, direction);
    const Cycle stiff_cycle = run_single_cycle(stiff, direction);
    ASSERT_TRUE(soft_cycle.converged() && stiff_cycle.converged());
    const double largest = stiff_cycle.turning_point->max_force;
    for (std::size_t k = 0; k < soft_cycle.increments.size(); ++k) {
      const FullIncrement a = increment_at(soft_cycle, static_cast<int>(k));
      const FullIncrement b = increment_at(stiff_cycle, static_cast<int>(k));
      ASSERT_LT((10.0 * normal_forces(a) - normal_forces(b)).cwiseAbs().maxCoeff(), 1e-10 * largest);
      ASSERT_NEAR(10.0 * a.force_direct, b.force_direct, 1e-10 * largest);
      expect_same_modes(a, b);
    }
  }
}

TEST(Symmetry, HeldJournalDoesNotCreep) {
  const Case input = rough_bearing();
  const BearingModel foils = *make_bearing_foils(input);
  NewtonSolver solver(foils.problem);
  ContactState state = ContactState::unstressed(foils.problem);
  for (int k = 0; k <= 20; ++k) {
    const ContactLoading loading = loading_under(foils, {.position = {k * 4e-6, 0.0}});
    ContactState next;
    ASSERT_TRUE(solver.solve(loading, state, next).converged());
    state = next;
  }
  const ContactLoading held = loading_under(foils, {.position = {20 * 4e-6, 0.0}});
  const ContactState reached = state;
  for (int k = 0; k < 100; ++k) {
    ContactState next;
    ASSERT_TRUE(solver.solve(held, state, next).converged());
    state = next;
  }
  const auto stuck = std::count(state.mode.begin(), state.mode.end(), ContactMode::stick);
  EXPECT_GT(stuck, 10);
  // Displacements of 0.1 mm are accurate to 1e-20 m; a penalty that restarts each time would move 1e-10 m.
  EXPECT_LT((tangential_displacements(foils.problem, state.x) - tangential_displacements(foils.problem, reached.x))
                .cwiseAbs()
                .maxCoeff(),
            1e-15);
  EXPECT_LT((state.friction_force - reached.friction_force).cwiseAbs().maxCoeff(),
            1e-9 * reached.normal_force.maxCoeff());
}

}  // namespace
}  // namespace bumpfoil
