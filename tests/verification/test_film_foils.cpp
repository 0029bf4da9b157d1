// docs/verification/film.md: the film over foils, against an independent prototype and rigid walls.

#include <gtest/gtest.h>

#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"
#include "support/film_runs.hpp"

namespace bumpfoil {
namespace {

/// Contacts of the prototype are compliant by a proximal term: measured effect at most 2e-6.
constexpr double derivative_tolerance = 1e-5;

TEST(FilmOverFoils, MeetsThePrototypeOnTheCoarsestMesh) {
  for (const ReferenceRun& run : reference_runs()) expect_run(run, run.levels.front());
}

/// Friction 0.1: the journal is pushed to 1.2 C_r in steps of 0.1 and drawn back to 0.4.
TEST(FilmOverFoils, MeetsThePrototypeAlongAFrictionPath) {
  const ReferencePath& path = reference_friction_path();
  const BearingModel bearing = film_reference_bearing(path.resolution, 0.1);
  FilmStepper stepper(bearing);
  BearingState state = resting(bearing, Eigen::Vector2d::Zero(), path.speed);
  double dissipated = 0.0;
  bool first = true;
  for (const ReferenceIncrement& increment : path.increments) {
    SCOPED_TRACE(increment.eccentricity);
    const Eigen::Vector2d position(increment.eccentricity * bearing.clearance, 0.0);
    const FilmReport report = first ? start_from_ambient(stepper, position, path.speed, state)
                                    : stepper.advance(OperatingPoint::held_at(position, path.speed), state);
    first = false;
    ASSERT_EQ(report.status, Status::converged);
    const Vector slip = tangential_displacements(bearing.problem, state.contacts.x) -
                        tangential_displacements(bearing.problem, state.slip_origin);
    dissipated += state.contacts.friction_force.cwiseProduct(slip).cwiseAbs().sum();
    const FilmBearingOutcome outcome = film_bearing_outcome(bearing, state);
    // Contacts of the prototype are compliant by a proximal term: five of its printed digits are exact.
    EXPECT_LT((outcome.force - increment.force).norm(), 1e-5 * increment.force.norm());
    EXPECT_NEAR(outcome.thinnest.thickness * bearing.film->scales.thickness, increment.thinnest,
                1e-5 * increment.thinnest);
    EXPECT_NEAR(outcome.power, increment.power, 1e-5 * increment.power);
    EXPECT_NEAR(dissipated, increment.dissipated, 1e-4 * increment.dissipated);
    EXPECT_EQ(outcome.loaded_bumps, increment.loaded_bumps);
  }
  for (std::size_t i = 0; i < path.last_bump_loads.size(); ++i) {
    EXPECT_NEAR(state.contacts.normal_force[static_cast<Eigen::Index>(2 * i)], path.last_bump_loads[i], 1e-4);  // N
  }
}

/// Loads along +X: start at 0.6 C_r along the load, then the load in ten steps. Compared are the stiffness there,
/// and the impedance to a whirl at the speed of rotation.
TEST(FilmOverFoils, CarriesLoadsWhereThePrototypeDoes) {
  for (const ReferenceEquilibrium& reference : reference_equilibria()) {
    SCOPED_TRACE(reference.load.x());
    Case input = film_reference_case(reference.resolution);
    input.settings.set(
        EquilibriumSettings{.speeds = {reference.speed}, .loads = {{reference.load.x(), reference.load.y()}}});
    const EquilibriumResult result = run_equilibrium(input);
    ASSERT_TRUE(result.converged());
    const RunningState& state = result.states.front();
    EXPECT_LT((state.last->position / input.bearing.radial_clearance - reference.position).norm(), 1e-6);
    const auto& K = state.stiffness;
    ASSERT_TRUE(K.has_value());
    EXPECT_LT((*K - reference.stiffness).norm(), derivative_tolerance * reference.stiffness.norm());
    const auto Z = FilmStepper(*result.bearing).impedances(*state.last, {{0.0, reference.speed}});
    ASSERT_TRUE(Z.has_value());
    EXPECT_LT(((*Z)[0] - reference.impedance).norm(), derivative_tolerance * reference.impedance.norm());
  }
}

/// With friction, after increments from unstressed foils to 0.8 C_r: closed contacts all stick, or keep their modes.
TEST(FilmOverFoils, WhirlsOverFrictionAsThePrototypeDoes) {
  const ReferencePath& path = reference_friction_path();
  const BearingModel bearing = film_reference_bearing(path.resolution, 0.1);
  FilmStepper stepper(bearing);
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, {0.1 * bearing.clearance, 0.0}, path.speed, state).status, Status::converged);
  for (int i = 2; i <= 8; ++i) {
    const Eigen::Vector2d position(0.1 * i * bearing.clearance, 0.0);
    ASSERT_EQ(stepper.advance(OperatingPoint::held_at(position, path.speed), state).status, Status::converged);
  }
  for (const ReferenceWhirl& reference : reference_friction_whirls()) {
    SCOPED_TRACE(reference.frequency);
    const auto Z = stepper.impedances(state, {{0.0, reference.frequency}}, reference.stuck);
    ASSERT_TRUE(Z.has_value());
    EXPECT_LT(((*Z)[0] - reference.impedance).norm(), derivative_tolerance * reference.impedance.norm());
  }
}

/// Foils and bumps made 1e9 times stiffer act as a rigid wall with a slot.
TEST(FilmOverFoils, TendsToTheRigidSlot) {
  BearingModel bearing = film_reference_bearing({.columns_per_pitch = 6, .rows = 8});
  const double speed = speed_of_rpm(45000.0);
  const Eigen::Vector2d position(0.5 * bearing.clearance, 0.1 * bearing.clearance);
  SolvedFilm rigid = solve_rigid_film(film_equation(*bearing.film, bearing.film->pads.front(), speed),
                                      undeformed_thickness(bearing, position));
  ASSERT_EQ(rigid.report.status, Status::converged);

  constexpr double stiffer = 1e9;
  for (Matrix& block : bearing.problem.K.diagonal) block *= stiffer;
  for (Matrix& block : bearing.problem.K.upper) block *= stiffer;
  bearing.film->pads.front().foil.top_foil.compliance_diagonal /= stiffer;
  bearing.film->pads.front().foil.top_foil.compliance_off /= stiffer;
  bearing.film->pads.front().foil.stiffness *= stiffer;
  bearing.film->pads.front().foil.load_scale /= stiffer;
  FilmStepper stepper(bearing);
  BearingState state;
  ASSERT_EQ(start_from_ambient(stepper, position, speed, state).status, Status::converged);
  const FilmIntegrals wall = film_integrals(rigid.equation, rigid.film);
  const FilmIntegrals foils = film_integrals(rigid.equation, state.film);
  const double load = std::hypot(wall.cosine, wall.sine);
  // The free end, which no load presses onto the sleeve, still moves by about 1e-6 of the clearance.
  EXPECT_NEAR(foils.cosine, wall.cosine, 5e-6 * load);
  EXPECT_NEAR(foils.sine, wall.sine, 5e-6 * load);
  EXPECT_GT(std::abs(foils.cosine - wall.cosine), 1e-12 * load);
}

/// Foil wrapped the other way and speed reversed: the mirrored bearing.
TEST(FilmOverFoils, MirroredBearingGivesTheMirroredForce) {
  const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 4, .rows = 4});
  BearingModel mirrored = bearing;
  mirrored.film->pads.front().wrap_sign = -bearing.film->pads.front().wrap_sign;
  mirrored.film->column_normals.row(1) *= -1.0;  // the weld is at -X
  const double speed = speed_of_rpm(45000.0);
  const double c = bearing.clearance;
  BearingState there, here;
  FilmStepper over_there(bearing), over_here(mirrored);
  ASSERT_EQ(start_from_ambient(over_there, {0.5 * c, 0.3 * c}, speed, there).status, Status::converged);
  ASSERT_EQ(start_from_ambient(over_here, {0.5 * c, -0.3 * c}, -speed, here).status, Status::converged);
  const FilmBearingOutcome a = film_bearing_outcome(bearing, there);
  const FilmBearingOutcome b = film_bearing_outcome(mirrored, here);
  EXPECT_EQ(a.force.x(), b.force.x());
  EXPECT_EQ(a.force.y(), -b.force.y());
  EXPECT_EQ(a.torque, -b.torque);
}

/// Energy, moments and mass, along a path to a heavily loaded bearing.
TEST(FilmOverFoils, IdentitiesHoldToTheOrderOfTheScheme) {
  double energy[2], moments[2];
  for (const int i : {0, 1}) {
    const BearingModel bearing = film_reference_bearing({.columns_per_pitch = 6 << i, .rows = 8 << i});
    const double speed = speed_of_rpm(45000.0);
    BearingState state;
    FilmStepper stepper(bearing);
    ASSERT_EQ(start_from_ambient(stepper, {0.6 * bearing.clearance, 0.0}, speed, state).status, Status::converged);
    const FilmBearingOutcome outcome = film_bearing_outcome(bearing, state);
    EXPECT_NEAR(outcome.flows.start, outcome.flows.end + outcome.flows.sides, 1e-12 * std::abs(outcome.flows.start));
    energy[i] = outcome.dissipation / outcome.power - 1.0;

    // T = Couette part - (x F_y - y F_x) / 2 - (sigma / 2) integral of (p - pa) du_t/dtheta.
    const FilmMesh& mesh = bearing.film->pads.front().foil.mesh;
    const FilmIntegrals sums =
        film_integrals(film_equation(*bearing.film, bearing.film->pads.front(), speed), state.film);
    double turning = 0.0;
    for (int k = 0; k < mesh.columns; ++k) {
      for (int j = 0; j < mesh.rows; ++j) {
        const double excess = 0.5 * (state.film.pressure(j, k) + state.film.pressure(j, k + 1)) - 1.0;
        turning +=
            2.0 * mesh.row_weight(j) * mesh.dzeta * excess * (state.film.deflection(k + 1) - state.film.deflection(k));
      }
    }
    turning *= bearing.film->scales.force() * bearing.film->scales.thickness;
    const double couette = bearing.film->scales.couette_torque(speed * bearing.film->scales.radius) * sums.couette;
    const double lever = state.position.x() * outcome.force.y() - state.position.y() * outcome.force.x();
    moments[i] = (couette - 0.5 * lever - 0.5 * bearing.film->pads.front().wrap_sign * turning) / outcome.torque - 1.0;
  }
  EXPECT_LT(std::abs(energy[0]), 2e-5);  // on 6x8
  EXPECT_LT(std::abs(moments[0]), 2e-5);
  EXPECT_LT(std::abs(energy[1]), 0.4 * std::abs(energy[0]));  // second order: a quarter
  EXPECT_LT(std::abs(moments[1]), 0.4 * std::abs(moments[0]));
}

}  // namespace
}  // namespace bumpfoil
