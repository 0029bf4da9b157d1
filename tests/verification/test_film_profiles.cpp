// A film in a sleeve that is not round, against the same film defined in another way, and by its identities.

#include <gtest/gtest.h>

#include <numbers>

#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/film/wall_film.hpp"
#include "bumpfoil/motion/rest.hpp"
#include "support/film_bearing_cases.hpp"

namespace bumpfoil {
namespace {

using std::numbers::pi;
const double film_speed = speed_of_rpm(45000.0);

/// From ambient pressure.
FilmBearingOutcome outcome_of(const Case& input, const Eigen::Vector2d& position) {
  const BearingModel bearing = make_film_bearing(input);
  BearingState state;
  FilmStepper stepper(bearing);
  EXPECT_EQ(start_from_ambient(stepper, position, film_speed, state).status, Status::converged);
  return film_bearing_outcome(bearing, state);
}

/// A sleeve with waves, a measured profile and a taper.
Case wavy_case(const FilmResolution& resolution) {
  Case input = film_reference_case(resolution, 0.1);
  input.bearing.sleeve.waves = {{.harmonic = 3, .amplitude = 3e-6, .phase = 0.4}};
  input.bearing.sleeve.deviations = {0.0, 2e-6, -1e-6, 1e-6};
  input.bearing.taper = 4e-6;
  return input;
}

TEST(FilmInSleeves, ThatAreWiderAllAroundHasAnotherClearance) {
  Case narrow = film_reference_case({.columns_per_pitch = 4, .rows = 6}, 0.1);
  Case wide = narrow;
  wide.bearing.sleeve.deviations = {4e-6};
  narrow.bearing.radial_clearance += 4e-6;
  const Eigen::Vector2d position(16e-6, 3e-6);
  const FilmBearingOutcome a = outcome_of(narrow, position);
  const FilmBearingOutcome b = outcome_of(wide, position);
  // Newton's last step is below 1e-9 of c.
  EXPECT_LT((a.force - b.force).norm(), 1e-6 * a.force.norm());
  EXPECT_NEAR(a.torque, b.torque, 1e-6 * a.torque);
}

TEST(FilmInSleeves, WithOneWaveIsThatOfAMovedJournal) {
  Case round = film_reference_case({.columns_per_pitch = 4, .rows = 6});
  round.settings.set(
      EquilibriumSettings{.speeds = {film_speed}, .positions = {{11e-6, 4e-6}}, .path = FilmPath::position_ray});
  for (const bool closed : {false, true}) {
    round.film.closed = closed;
    Case waves = round;
    waves.bearing.sleeve.waves = {{.harmonic = 1, .amplitude = 5e-6, .phase = 0.5 * pi}};
    waves.settings.get<EquilibriumSettings>().positions = {{11e-6, 9e-6}};
    const EquilibriumResult a = run_wall_films(round);
    const EquilibriumResult b = run_wall_films(waves);
    ASSERT_TRUE(a.converged() && b.converged());
    const Eigen::Vector2d force = a.states[0].outcome->force;
    EXPECT_LT((force - b.states[0].outcome->force).norm(), 1e-7 * force.norm());
  }
}

TEST(FilmInSleeves, TurnsWithBearingAndLoad) {
  const Case input = wavy_case({.columns_per_pitch = 4, .rows = 6});
  Case turned = input;
  turned.bearing.weld_angle += 0.5 * pi;
  turned.bearing.sleeve.waves[0].phase += 3 * 0.5 * pi;
  turned.bearing.sleeve.deviations = {1e-6, 0.0, 2e-6, -1e-6};
  const Eigen::Vector2d here = outcome_of(input, {15e-6, 2e-6}).force;
  const Eigen::Vector2d there = outcome_of(turned, {-2e-6, 15e-6}).force;
  EXPECT_LT((there - Eigen::Vector2d(-here.y(), here.x())).norm(), 1e-7 * here.norm());
  // The waves have an effect.
  EXPECT_GT(
      (here -
       outcome_of(film_reference_case(FilmResolution{.columns_per_pitch = 4, .rows = 6}, 0.1), {15e-6, 2e-6}).force)
          .norm(),
      0.05 * here.norm());
}

TEST(FilmInSleeves, KeepsItsBalances) {
  double energy[2], moments[2];
  for (const int i : {0, 1}) {
    const FilmBearingOutcome outcome =
        outcome_of(wavy_case({.columns_per_pitch = 6 << i, .rows = 8 << i}), {15e-6, 0.0});
    EXPECT_NEAR(outcome.flows.start, outcome.flows.end + outcome.flows.sides, 1e-12 * std::abs(outcome.flows.start));
    energy[i] = std::abs(outcome.dissipation / outcome.power - 1.0);
    moments[i] = std::abs(outcome.torque_of_moments / outcome.torque - 1.0);
  }
  // Second order: a quarter.
  EXPECT_LT(energy[0], 2e-5);
  EXPECT_LT(moments[0], 1e-4);
  EXPECT_LT(energy[1], 0.4 * energy[0]);
  EXPECT_LT(moments[1], 0.4 * moments[0]);
}

}  // namespace
}  // namespace bumpfoil
