/// The response computed from event to event, against increments and energy balances.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/bearing/foil_stepper.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/bearing_cases.hpp"
#include "support/full_increment.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

Case with_events(Case input) {
  input.solver.name = SolverName::events;
  return input;
}

Case with_height_errors() {
  Case input = case_with_given_constants();
  for (int i = 0; i < input.bump_foil.bumps; ++i)
    input.bump_foil.height_errors.push_back(8e-6 * std::sin(2.0 + 5.0 * i));
  return input;
}

double most_work(const Cycle& cycle) {
  double largest = 0.0;
  for (const Increment& increment : cycle.increments) largest = std::max(largest, std::abs(increment.work));
  return largest;
}

class EventCycles : public testing::TestWithParam<double> {};

/// Plain balance W = E - E0 + D: increments have a first-order defect, the path from event to event has none.
TEST_P(EventCycles, KeepThePlainEnergyBalance) {
  for (const Case& input : {case_with_given_constants(), with_height_errors()}) {
    const Cycle cycle = run_single_cycle(with_events(input), GetParam());
    ASSERT_EQ(first_failure(cycle), "");
    EXPECT_EQ(cycle.substeps, 0);
    const double scale = most_work(cycle);
    const double start = cycle.increments.front().elastic_energy;
    for (const Increment& k : cycle.increments) {
      // Sums of a few hundred pieces, each with a round-off of 1e-16.
      EXPECT_NEAR(k.work, k.elastic_energy - start + k.dissipated_energy, 1e-9 * scale) << k.index;
    }
  }
}

/// The loop energy depends on the path, not on its increments.
TEST_P(EventCycles, DoNotDependOnTheNumberOfSteps) {
  Case input = with_events(case_with_given_constants());
  input.settings.get<CycleSettings>().steps = 10;
  const Cycle coarse = run_single_cycle(input, GetParam());
  input.settings.get<CycleSettings>().steps = 130;
  const Cycle fine = run_single_cycle(input, GetParam());
  ASSERT_TRUE(coarse.turning_point && fine.turning_point && coarse.loop_energy && fine.loop_energy);
  EXPECT_NEAR(coarse.turning_point->max_force, fine.turning_point->max_force, 1e-9 * fine.turning_point->max_force);
  EXPECT_NEAR(*coarse.loop_energy, *fine.loop_energy, 1e-9 * most_work(fine));
}

/// The exact solver, with increments that end exactly at the events, gives the same response.
TEST_P(EventCycles, AgreeWithIncrementsPlacedAtTheEvents) {
  for (const Case& input : {case_with_given_constants(), with_height_errors()}) {
    const Cycle events = run_single_cycle(with_events(input), GetParam());
    ASSERT_TRUE(events.converged());

    FoilStepper newton = make_stepper(make_bearing_foils(input), {.name = SolverName::newton, .uzawa = {}});
    const Eigen::Vector2d n = unit_vector(GetParam());
    Step step;
    newton.assemble({}, step);
    ASSERT_TRUE(step.converged());
    for (const Branch branch : {Branch::loading, Branch::unloading}) {
      std::vector<double> stops{branch == Branch::loading ? events.amplitude : 0.0};
      for (const CycleEvent& event : events.events) {
        if (event.branch == branch) stops.push_back(event.displacement);
      }
      std::sort(stops.begin(), stops.end());
      if (branch == Branch::unloading) std::reverse(stops.begin(), stops.end());
      for (const double stop : stops) {
        const BearingState state = step.state;
        newton.advance(state, {.position = stop * n}, step);
        ASSERT_TRUE(step.converged());
      }
      if (branch == Branch::loading) {
        const double force = holding_force(newton.foils(), step.state.contacts.normal_force).dot(n);
        EXPECT_NEAR(force, events.turning_point->max_force, 1e-9 * events.turning_point->max_force);
      }
    }
    EXPECT_NEAR(step.state.work, *events.loop_energy, 1e-8 * most_work(events));
  }
}

INSTANTIATE_TEST_SUITE_P(Directions, EventCycles, testing::Values(0.0, std::numbers::pi, 0.5 * std::numbers::pi, 4.0));

/// Frictionless bumps so short and thick that no modes work after some events: newton takes small increments.
Case short_stiff_bumps() {
  Case input = case_with_given_constants();
  input.bearing = {
      .radius = 0.004261487411939364, .axial_length = 0.04841632787397465, .radial_clearance = 8.972962488659042e-05};
  input.bump_foil = {.model = BumpFoilModel::frame,
                     .bumps = 53,
                     .pitch = 0.0005052021715736113,
                     .length = 0.0003353093020518484,
                     .height = 0.00017525082773990782,
                     .thickness = 0.000105447049093182,
                     .youngs_modulus = 196201402653.22522,
                     .poisson_ratio = 0.29,
                     .height_errors = {},
                     .sleeve_gaps = {},
                     .weld_at = WeldPosition::arc_start,
                     .truss = {}};
  input.top_foil = {
      .thickness = 2.2544859624343658e-05, .youngs_modulus = input.bump_foil.youngs_modulus, .poisson_ratio = 0.29};
  input.friction = {};
  input.settings.get<CycleSettings>().amplitude.value = 0.00010799717071993301;
  return input;
}

/// Friction of 1 under a preload: the foils snap along the path.
Case snapping_bumps() {
  Case input = case_with_given_constants();
  input.bearing = {.radius = 0.02052479310246199,
                   .axial_length = 0.01887256374438901,
                   .radial_clearance = -5.481558292187019e-06,
                   .wrap = Wrap::counterclockwise};
  input.bump_foil = {.model = BumpFoilModel::frame,
                     .bumps = 57,
                     .pitch = 0.002262475060599318,
                     .length = 0.0007922043244122146,
                     .height = 0.0007886662703035484,
                     .thickness = 0.0003577571456624189,
                     .youngs_modulus = 44824543594.301445,
                     .poisson_ratio = 0.0,
                     .height_errors = {},
                     .sleeve_gaps = {},
                     .weld_at = WeldPosition::arc_start,
                     .truss = {}};
  input.top_foil = {
      .thickness = 0.00035033194299343475, .youngs_modulus = input.bump_foil.youngs_modulus, .poisson_ratio = 0.0};
  input.friction = {.top_bump = 1.0, .bump_sleeve = 0.0};
  input.settings.get<CycleSettings>().amplitude.value = 1.6063897939869458e-05;
  return input;
}

/// If the response contains small increments of newton or jumps, work is still stored or dissipated, to 1e-7.
TEST(Events, KeepTheEnergyWhereTheyCannotBeFollowed) {
  for (Case input : {short_stiff_bumps(), snapping_bumps()}) {
    std::vector<double> loops;
    for (const int steps : {2, 5}) {
      input.settings.get<CycleSettings>().steps = steps;
      const Cycle cycle = run_single_cycle(with_events(input), 0.0);
      ASSERT_EQ(first_failure(cycle), "");
      const double scale = most_work(cycle);
      const double start = cycle.increments.front().elastic_energy;
      for (const Increment& k : cycle.increments) {
        EXPECT_NEAR(k.work, k.elastic_energy - start + k.dissipated_energy, 1e-7 * scale) << k.index;
      }
      if (input.friction == Friction{}) {
        EXPECT_NEAR(*cycle.loop_energy, 0.0, 1e-7 * scale);
      }
      loops.push_back(*cycle.loop_energy / scale);
    }
    EXPECT_NEAR(loops[0], loops[1], 1e-7);  // depends on the path, not on its increments
  }
}

/// Feet over gaps carry nothing before the journal touches or after it has left, except for round-off.
TEST(Events, LeaveContactsOpenWhereNothingIsLoaded) {
  Case input = with_events(case_with_given_constants());
  input.friction = {};
  input.settings.get<CycleSettings>().steps = 20;
  for (int i = 0; i < input.bump_foil.bumps; ++i) input.bump_foil.sleeve_gaps.push_back(1e-6 * (1 + i * 7 % 24));
  for (const double direction : {0.0, 0.5 * std::numbers::pi}) {
    const Cycle cycle = run_single_cycle(input, direction);
    ASSERT_EQ(first_failure(cycle), "");
    for (const FullIncrement& k : full_increments(cycle)) {
      for (Eigen::Index foot = 0; foot < k.foot_v.size(); ++foot) {
        const double stands_off = input.bump_foil.sleeve_gaps[static_cast<std::size_t>(foot)] - k.foot_v[foot];
        EXPECT_NEAR(k.bump_sleeve.gap[foot], std::max(0.0, stands_off), 1e-12) << k.index << ", foot " << foot;
      }
    }
  }
}

TEST(Events, UniformIncrementsApproachThePath) {
  Case input = case_with_given_constants();
  const double exact = *run_single_cycle(with_events(input), 0.0).loop_energy;
  std::vector<double> error;
  for (const int steps : {10, 40, 160, 640}) {
    input.settings.get<CycleSettings>().steps = steps;
    error.push_back(std::abs(*run_single_cycle(input, 0.0).loop_energy - exact) / exact);
  }
  // First order: a quarter for four times the steps; a factor of two allows for events within increments.
  for (std::size_t i = 1; i < error.size(); ++i) EXPECT_LT(error[i], 0.5 * error[i - 1]);
  EXPECT_LT(error.back(), 1e-3);
}

TEST(Events, AreListedInOrderWithWhatChanged) {
  const Cycle cycle = run_single_cycle(with_events(case_with_given_constants()), 0.0);
  ASSERT_FALSE(cycle.events.empty());
  // No event can occur before the journal touches.
  EXPECT_GE(cycle.events.front().displacement, *cycle.first_contact * (1.0 - 1e-12));
  EXPECT_TRUE(std::is_sorted(cycle.events.begin(), cycle.events.end(), [](const CycleEvent& a, const CycleEvent& b) {
    if (a.branch != b.branch) return a.branch == Branch::loading;
    return a.branch == Branch::loading ? a.displacement < b.displacement : a.displacement > b.displacement;
  }));
  for (const CycleEvent& event : cycle.events) EXPECT_NE(event.from, event.to);
}

}  // namespace
}  // namespace bumpfoil
