#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/bearing_cases.hpp"

/// Sleeves and journals that are not round, against the same gaps defined in another way.
namespace bumpfoil {
namespace {

using std::numbers::pi;

Case pushed(double amplitude, int steps) {
  Case input = reference_case();
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.amplitude.value = amplitude;
  cycle.steps = steps;
  return input;
}

void expect_same(const Cycle& a, const Cycle& b, double part) {
  ASSERT_TRUE(a.converged() && b.converged());
  ASSERT_EQ(a.increments.size(), b.increments.size());
  const double force = a.turning_point->max_force;
  ASSERT_GT(force, 0.0);
  for (std::size_t k = 0; k < a.increments.size(); ++k) {
    ASSERT_NEAR(a.increments[k].force_direct, b.increments[k].force_direct, part * force) << k;
    ASSERT_NEAR(a.increments[k].force_cross, b.increments[k].force_cross, part * force) << k;
  }
}

TEST(Profiles, ThatAreTheSameAllAroundAreAnotherClearance) {
  const Case plain = pushed(60e-6, 15);
  Case wider = plain;
  wider.bearing.radial_clearance += 6e-6;
  Case sleeve = plain;
  sleeve.bearing.sleeve.deviations = {6e-6};
  Case journal = plain;
  journal.bearing.journal.deviations.assign(7, -6e-6);
  // Sums of gaps have a round-off of 1e-20 m; stiffnesses reach 1e8 N/m.
  expect_same(run_single_cycle(wider, 0.0), run_single_cycle(sleeve, 0.0), 1e-9);
  expect_same(run_single_cycle(wider, 0.0), run_single_cycle(journal, 0.0), 1e-9);
}

TEST(Profiles, OneWaveOfTheJournalMovesIt) {
  // Without friction the force depends only on the position.
  Case plain = pushed(60e-6, 60);
  plain.friction = {};
  Case moved = plain;
  const double direction = 0.5 * pi;
  moved.bearing.journal.waves = {{.harmonic = 1, .amplitude = 5e-6, .phase = direction}};
  const Cycle here = run_single_cycle(plain, direction);
  const Cycle ahead = run_single_cycle(moved, direction);
  ASSERT_TRUE(here.converged() && ahead.converged());
  for (std::size_t k = 0; k + 5 <= 60; ++k) {
    EXPECT_NEAR(ahead.increments[k].force_direct, here.increments[k + 5].force_direct,
                1e-9 * here.turning_point->max_force);
  }
}

TEST(Profiles, TurnWithTheBearing) {
  Case input = pushed(60e-6, 15);
  input.bearing.sleeve.waves = {{.harmonic = 3, .amplitude = 5e-6, .phase = 0.3}};
  input.bearing.sleeve.deviations = {0.0, 2e-6, -3e-6, 1e-6};
  input.bearing.journal.waves = {{.harmonic = 2, .amplitude = 4e-6, .phase = -0.8}};
  Case turned = input;
  const double quarter = 0.5 * pi;
  turned.bearing.weld_angle += quarter;
  turned.bearing.sleeve.waves.front().phase += 3.0 * quarter;
  turned.bearing.sleeve.deviations = {1e-6, 0.0, 2e-6, -3e-6};
  turned.bearing.journal.waves.front().phase += 2.0 * quarter;
  expect_same(run_single_cycle(input, 0.0), run_single_cycle(turned, quarter), 1e-9);
}

TEST(Profiles, MeasuredWavesAreWaves) {
  Case waves = pushed(60e-6, 15);
  waves.bearing.sleeve.waves = {{.harmonic = 3, .amplitude = 5e-6, .phase = 0.3}};
  Case measured = pushed(60e-6, 15);
  for (int i = 0; i < 3600; ++i) {
    measured.bearing.sleeve.deviations.push_back(deviation_at(waves.bearing.sleeve, 2.0 * pi * i / 3600.0));
  }
  // Linear interpolation between two points errs by (3 * 2 pi / 3600)^2 / 8 = 3e-6 of the amplitude.
  expect_same(run_single_cycle(waves, pi), run_single_cycle(measured, pi), 1e-4);
}

TEST(Profiles, ATaperIsASleeveThatWidensFromTheWeldOn) {
  Case tapered = pushed(60e-6, 15);
  tapered.bearing.taper = 10e-6;
  Case measured = pushed(60e-6, 15);
  // Clockwise from the weld at 180 degrees angles decrease. Behind the free end the taper stays constant.
  const double end = foil_angle(measured);
  for (int i = 0; i < 3600; ++i) {
    const double theta = 2.0 * pi * std::fmod(1.5 - i / 3600.0, 1.0);
    measured.bearing.sleeve.deviations.push_back(theta < end ? 10e-6 * theta / end : 10e-6);
  }
  expect_same(run_single_cycle(tapered, 0.0), run_single_cycle(measured, 0.0), 1e-9);
  EXPECT_LT(run_single_cycle(tapered, 0.0).turning_point->max_force,
            0.95 * run_single_cycle(pushed(60e-6, 15), 0.0).turning_point->max_force);
}

}  // namespace
}  // namespace bumpfoil
