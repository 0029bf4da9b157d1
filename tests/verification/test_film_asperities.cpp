// docs/verification/film.md: rough surfaces in contact under the film, against the dry bearing, differences and
// symmetry.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/bearing/fields.hpp"
#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/motion/load_search.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

constexpr FilmResolution mesh{.columns_per_pitch = 6, .rows = 4};

/// The reference bearing with rough surfaces, K' = 240 MPa.
Case rough_case(double rpm, const Eigen::Vector2d& load, double friction = 0.0) {
  Case input = film_reference_case(mesh, friction);
  input.asperity = AsperitySettings{.sigma = 0.3e-6, .pressure_factor = 240e6, .friction = 0.2};
  input.settings.set(EquilibriumSettings{.speeds = {speed_of_rpm(rpm)}, .loads = {load}});
  return input;
}

RunningState rough_state(const Case& input) {
  const EquilibriumResult result = run_equilibrium(input);
  EXPECT_TRUE(result.states.front().found());
  return result.states.front();
}

/// With almost smooth surfaces a journal at rest lies on the foils as without a film, where contacts are rigid and
/// exact: another solver on another matrix.
TEST(FilmAsperities, RestsWhereTheDryBearingDoes) {
  const Eigen::Vector2d load(50.0, 0.0);
  Case input = rough_case(0.0, load);
  input.asperity->sigma = 0.01e-6;
  const RunningState running = rough_state(input);
  const Vector loads = bump_loads(make_film_bearing(input), *running.last);

  FoilStepper dry = make_stepper(make_bearing_foils(input));
  Step step;
  advance_to_load(dry, BearingState::unstressed(dry.foils()), load, 1e-6, 3.0 * input.bearing.radial_clearance, step);
  ASSERT_TRUE(step.converged());
  // Asperities keep the surfaces 0.03 um apart.
  EXPECT_NEAR(running.last->position.x(), step.state.position.x(), 0.05e-6);
  const Vector dry_loads = interface_loads(dry.foils(), step.state.contacts, Interface::top_bump);
  ASSERT_EQ(loads.size(), dry_loads.size());
  EXPECT_LT((loads - dry_loads).cwiseAbs().maxCoeff(), 2e-3 * dry_loads.maxCoeff());
  EXPECT_NEAR(running.outcome->asperity_force.x(), 50.0, 1e-6);
  EXPECT_NEAR(running.outcome->torque, 0.0, 1e-20);  // round-off of P = 1
  EXPECT_NEAR(running.outcome->max_pressure, 1.0, 1e-9);
}

/// Consistent derivatives where asperities carry much of the load: held journal, central differences of its force.
TEST(FilmAsperities, StiffnessIsThatOfDifferences) {
  const Case input = rough_case(300.0, {30.0, 0.0});
  const RunningState state = rough_state(input);
  const double share = state.outcome->asperity_force.x() / state.outcome->force.x();
  EXPECT_GT(share, 0.05);
  EXPECT_LT(share, 0.95);
  FilmStepper stepper(make_film_bearing(input));
  const auto force_at = [&](const Eigen::Vector2d& position) {
    BearingState moved = *state.last;
    EXPECT_EQ(stepper.advance(OperatingPoint::held_at(position, moved.speed), moved).status, Status::converged);
    return Eigen::Vector2d(film_bearing_outcome(stepper.bearing(), moved).force);
  };
  const double d = 2e-11;  // m: 1/15,000 of a roughness, so that differences err by 1e-8 of the slope
  ASSERT_TRUE(state.stiffness.has_value());
  for (const int axis : {0, 1}) {
    const Eigen::Vector2d step = d * Eigen::Vector2d::Unit(axis);
    const Eigen::Vector2d difference =
        (force_at(state.last->position + step) - force_at(state.last->position - step)) / (2.0 * d);
    EXPECT_LT((difference - state.stiffness->col(axis)).norm(), 1e-5 * state.stiffness->norm());
  }
  // The same from the reduced model of motions in time, in the limit of slow motion.
  const auto Z = stepper.impedances(*state.last, {{0.0, 1e-3 * state.last->speed}});
  ASSERT_TRUE(Z.has_value());
  EXPECT_LT((Z->front().real() - *state.stiffness).norm(), 1e-4 * state.stiffness->norm());
  EXPECT_TRUE(state.held.sliding.has_value());  // present only if its residual in all equations is small
}

/// Input power is dissipated by shear, flow and friction; friction follows from the pressures at the columns.
TEST(FilmAsperities, PowerIsDissipated) {
  const Case input = rough_case(300.0, {30.0, 0.0});
  const BearingModel bearing = make_film_bearing(input);
  const RunningState state = rough_state(input);
  const FilmBearingOutcome& outcome = *state.outcome;
  const FilmPad& pad = bearing.film->pads.front();
  double normal = 0.0;
  for (int k = 0; k < bearing.film->columns(); ++k) {
    const double h = bearing.film->scales.thickness * state.last->film.thickness(0, k);
    normal += bearing.film->surroundings.asperities->pressure(h) * pad.foil.mesh.column_weight(k);
  }
  normal *= bearing.film->scales.radius * pad.foil.mesh.dtheta * input.bearing.axial_length;
  EXPECT_NEAR(outcome.asperity_torque, 0.2 * bearing.film->scales.radius * normal, 1e-12);
  EXPECT_GT(outcome.asperity_torque, 0.5 * outcome.torque);
  // The mesh makes an error of a few per cent of the rest; a wrong share of friction would be half of the total.
  EXPECT_NEAR(outcome.dissipation, outcome.power, 0.05 * outcome.power);
  EXPECT_NEAR(outcome.torque_of_moments, outcome.torque, 0.05 * outcome.torque);
}

/// The same bearing turned, and mirrored with the speed.
TEST(FilmAsperities, TurnsAndMirrors) {
  const Case input = rough_case(800.0, {25.0, 10.0}, 0.1);
  const RunningState here = rough_state(input);
  constexpr double angle = 0.7;
  Case turned = input;
  turned.bearing.weld_angle += angle;
  turned.settings.get<EquilibriumSettings>().loads = {
      Eigen::Vector2d(Eigen::Rotation2Dd(angle) * input.settings.get<EquilibriumSettings>().loads.front())};
  const RunningState there = rough_state(turned);
  EXPECT_LT((Eigen::Rotation2Dd(-angle) * there.last->position - here.last->position).norm(),
            1e-7 * input.bearing.radial_clearance);
  EXPECT_NEAR(there.outcome->torque, here.outcome->torque, 1e-7 * here.outcome->torque);

  Case mirrored = input;  // about the X axis
  mirrored.bearing.weld_angle = -input.bearing.weld_angle;
  mirrored.bearing.wrap = Wrap::counterclockwise;
  EquilibriumSettings& equilibrium = mirrored.settings.get<EquilibriumSettings>();
  equilibrium.speeds = {-input.settings.get<EquilibriumSettings>().speeds.front()};
  equilibrium.loads = {{25.0, -10.0}};
  const RunningState image = rough_state(mirrored);
  EXPECT_NEAR(image.last->position.y(), -here.last->position.y(), 1e-7 * input.bearing.radial_clearance);
  EXPECT_NEAR(image.outcome->torque, -here.outcome->torque, 1e-7 * here.outcome->torque);
}

/// A misaligned journal, with asperity contact on the side it leans to: stiffness in all four motions against central
/// differences, and the balances of power and torque.
TEST(FilmAsperities, CarryATiltedJournal) {
  Case input = rough_case(1000.0, {30.0, 0.0});
  input.width = {.modes = 3, .tilt = {1e-4, 0.0}};
  const RunningState state = rough_state(input);
  FilmStepper stepper(make_film_bearing(input));
  const BearingModel& bearing = stepper.bearing();
  const Matrix pressures = asperity_pressures(*bearing.film, state.last->film.thickness);
  const Eigen::Index sides = pressures.rows() - 1;
  EXPECT_GT(state.outcome->asperity_force.x(), 1.0);
  EXPECT_GT(pressures.row(sides).maxCoeff(), 100.0 * pressures.row(0).maxCoeff());
  EXPECT_GT(state.outcome->moment.x(), bearing.film->half_width() * 0.1 * state.outcome->asperity_force.x());

  const auto force_at = [&](const JournalVector& journal) {
    BearingState moved = *state.last;
    OperatingPoint point = OperatingPoint::held_at(journal.head<2>(), moved.speed);
    point.tilt.value = journal.tail<2>();
    EXPECT_EQ(stepper.advance(point, moved).status, Status::converged);
    return journal_force(*bearing.film, moved.film, moved.speed);
  };
  ASSERT_TRUE(state.stiffness.has_value());
  const JournalVector journal = bearing.film->journal_of(*state.last);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const JournalVector step = 2e-11 * JournalVector::Unit(4, i);
    const JournalVector difference = (force_at(journal + step) - force_at(journal - step)) / 4e-11;
    JournalMatrix expected = JournalMatrix::Zero(4, 4);
    expected.col(i) = difference;
    // Relative to the columns by displacements, or to those by slopes.
    const double largest = state.stiffness->middleCols(i - i % 2, 2).norm();
    EXPECT_LT((bearing.film->by_slopes(expected) - *state.stiffness).col(i).norm(), 1e-5 * largest) << i;
  }
  EXPECT_TRUE(state.held.sliding.has_value());
  EXPECT_NEAR(state.outcome->dissipation, state.outcome->power, 0.05 * state.outcome->power);
  EXPECT_NEAR(state.outcome->torque_of_moments, state.outcome->torque, 0.05 * state.outcome->torque);
}

/// A journal that may tilt but does not gives the result of half the width.
TEST(FilmAsperities, AreTheSameOnTheWholeWidth) {
  const Case half = rough_case(500.0, {30.0, 0.0}, 0.1);
  Case whole = half;
  whole.width.moment = {0.0, 0.0};
  const RunningState here = rough_state(half);
  const RunningState there = rough_state(whole);
  EXPECT_GT(here.outcome->asperity_force.x(), 1.0);
  EXPECT_LT((there.last->position - here.last->position).norm(), 1e-7 * half.bearing.radial_clearance);
  EXPECT_NEAR(there.outcome->torque, here.outcome->torque, 1e-7 * here.outcome->torque);
  EXPECT_NEAR(there.outcome->asperity_torque, here.outcome->asperity_torque, 1e-6 * here.outcome->torque);
}

/// At rest under a tilt, stiff asperities hold the journal as in the dry bearing, where it touches the foils on three
/// lines over the width instead of at all rows.
TEST(FilmAsperities, HoldATiltedJournalAtRestAsWithoutAFilm) {
  const Eigen::Vector2d load(50.0, 0.0);
  Case input = rough_case(0.0, load);
  input.asperity->sigma = 0.01e-6;
  input.width = {.modes = 3, .tilt = {5e-6 / input.bearing.axial_length, 0.0}};
  const RunningState running = rough_state(input);

  FoilStepper dry = make_stepper(make_bearing_foils(input));
  Step step;
  advance_to_load(dry, BearingState::unstressed(dry.foils()), load, 1e-6, 3.0 * input.bearing.radial_clearance, step);
  ASSERT_TRUE(step.converged());
  const double moment = holding_moment(dry.foils(), step.state.contacts.normal_force).x();
  // Asperities keep the surfaces 0.03 um apart.
  EXPECT_NEAR(running.last->position.x(), step.state.position.x(), 0.05e-6);
  EXPECT_NEAR(running.outcome->moment.x(), moment, 2e-3 * moment);
  EXPECT_GT(moment, 0.1);
}

/// From rest to speed: the load moves from asperities to gas; the torque is minimum where the surfaces separate.
TEST(FilmAsperities, RunUpFromRestIsACurveOfStribeck) {
  Case input = rough_case(0.0, {50.0, 0.0}, 0.1);
  input.top_foil.formed_radius = {FormedTo::seated};
  EquilibriumSettings& equilibrium = input.settings.get<EquilibriumSettings>();
  equilibrium.path = FilmPath::speed_ramp;
  equilibrium.speeds.clear();
  for (const double rpm : {0.0, 300.0, 1000.0, 2000.0, 4000.0, 10000.0, 30000.0}) {
    equilibrium.speeds.push_back(speed_of_rpm(rpm));
  }
  const EquilibriumResult result = run_equilibrium(input);
  ASSERT_TRUE(result.converged());
  std::vector<double> torque, share;
  for (const RunningState& state : result.states) {
    torque.push_back(state.outcome->torque);
    share.push_back(state.outcome->asperity_force.x() / 50.0);
  }
  EXPECT_EQ(torque.front(), 0.0);
  EXPECT_NEAR(share.front(), 1.0, 1e-7);
  EXPECT_TRUE(std::is_sorted(share.rbegin(), share.rend()));
  EXPECT_LT(share.back(), 1e-9);
  // If asperities carried all of the load, friction would be 0.2 x 50 N x 19.05 mm.
  EXPECT_GT(torque[1], 0.5 * 0.1905);
  EXPECT_LT(torque[1], 0.1905);
  const auto least = std::min_element(torque.begin() + 1, torque.end());
  EXPECT_TRUE(least != torque.begin() + 1 && least != torque.end() - 1);
  const auto i = static_cast<std::size_t>(least - torque.begin());
  ASSERT_TRUE(result.states.front().least_torque_speed.has_value());
  EXPECT_GT(*result.states.front().least_torque_speed, equilibrium.speeds[i - 1]);
  EXPECT_LT(*result.states.front().least_torque_speed, equilibrium.speeds[i + 1]);
}

}  // namespace
}  // namespace bumpfoil
