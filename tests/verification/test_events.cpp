/// The response followed from event to event, against increments and against the energies.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/analysis/energy.hpp"
#include "bumpfoil/analysis/path_solver.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/bearing_cases.hpp"
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

double largest_work(const Cycle& cycle) {
  double largest = 0.0;
  for (const Increment& increment : cycle.increments) largest = std::max(largest, std::abs(increment.work));
  return largest;
}

class EventCycles : public testing::TestWithParam<double> {};

/// Plain balance W = E - E0 + D: an increment has a first-order defect, the path from event to event has none.
TEST_P(EventCycles, KeepThePlainEnergyBalance) {
  for (const Case& input : {case_with_given_constants(), with_height_errors()}) {
    const Cycle cycle = run_single_cycle(with_events(input), GetParam());
    ASSERT_EQ(first_failure(cycle), "");
    EXPECT_EQ(cycle.substeps(), 0);
    const double scale = largest_work(cycle);
    const double start = cycle.increments.front().elastic_energy;
    for (const Increment& k : cycle.increments) {
      // Sums of some hundred pieces with roundings of 1e-16 each.
      EXPECT_NEAR(k.work, k.elastic_energy - start + k.dissipated_energy, 1e-9 * scale) << k.index;
    }
  }
}

/// The loop is that of the path, not of its increments.
TEST_P(EventCycles, DoNotDependOnTheNumberOfSteps) {
  Case input = with_events(case_with_given_constants());
  input.cycle.steps = 10;
  const Cycle coarse = run_single_cycle(input, GetParam());
  input.cycle.steps = 130;
  const Cycle fine = run_single_cycle(input, GetParam());
  ASSERT_TRUE(coarse.turning_point && fine.turning_point && coarse.loop_energy && fine.loop_energy);
  EXPECT_NEAR(coarse.turning_point->max_force, fine.turning_point->max_force, 1e-9 * fine.turning_point->max_force);
  EXPECT_NEAR(*coarse.loop_energy, *fine.loop_energy, 1e-9 * largest_work(fine));
}

/// Increments of the exact solver that end exactly where something happens see the same response.
TEST_P(EventCycles, AgreeWithIncrementsPlacedAtTheEvents) {
  for (const Case& input : {case_with_given_constants(), with_height_errors()}) {
    const Cycle events = run_single_cycle(with_events(input), GetParam());
    ASSERT_TRUE(events.converged);

    const FoilModel model = make_bearing_model(input);
    PathSolver newton({.name = SolverName::newton, .uzawa = {}}, model.problem);
    const Eigen::Vector2d n = unit_vector(GetParam());
    ContactState state = ContactState::unstressed(model.problem);
    const ContactState unstressed = state;
    ContactLoading loading = loading_at(model, Eigen::Vector2d::Zero());
    ASSERT_TRUE(newton.assemble(loading, unstressed, state).converged);
    double work = 0.0;
    const auto visit = [&](const ContactState& begin, const ContactState& end) {
      work += gap_work(model.problem, begin, end);
    };
    for (const Branch branch : {Branch::loading, Branch::unloading}) {
      std::vector<double> stops{branch == Branch::loading ? events.amplitude : 0.0};
      for (const CycleEvent& event : events.events) {
        if (event.branch == branch) stops.push_back(event.displacement);
      }
      std::sort(stops.begin(), stops.end());
      if (branch == Branch::unloading) std::reverse(stops.begin(), stops.end());
      std::vector<ContactEvent> none;
      for (const double stop : stops) {
        const ContactLoading next = loading_at(model, stop * n);
        newton.set_out(loading, next, state);
        ASSERT_TRUE(newton.advance_to(1.0, state, visit, none).solve.converged);
        loading = next;
      }
      if (branch == Branch::loading) {
        const double force = holding_force(model, state.normal_force).dot(n);
        EXPECT_NEAR(force, events.turning_point->max_force, 1e-9 * events.turning_point->max_force);
      }
    }
    EXPECT_NEAR(work, *events.loop_energy, 1e-8 * largest_work(events));
  }
}

INSTANTIATE_TEST_SUITE_P(Directions, EventCycles, testing::Values(0.0, std::numbers::pi, 0.5 * std::numbers::pi, 4.0));

TEST(Events, UniformIncrementsApproachThePath) {
  Case input = case_with_given_constants();
  const double exact = *run_single_cycle(with_events(input), 0.0).loop_energy;
  std::vector<double> error;
  for (const int steps : {10, 40, 160, 640}) {
    input.cycle.steps = steps;
    error.push_back(std::abs(*run_single_cycle(input, 0.0).loop_energy - exact) / exact);
  }
  // First order would be a quarter for four times the steps; where events fall between increments leaves a factor two.
  for (std::size_t i = 1; i < error.size(); ++i) EXPECT_LT(error[i], 0.5 * error[i - 1]);
  EXPECT_LT(error.back(), 1e-3);
}

TEST(Events, AreListedInOrderWithWhatChanged) {
  const Cycle cycle = run_single_cycle(with_events(case_with_given_constants()), 0.0);
  ASSERT_FALSE(cycle.events.empty());
  // Nothing can happen before the journal touches.
  EXPECT_GE(cycle.events.front().displacement, *cycle.first_contact * (1.0 - 1e-12));
  EXPECT_TRUE(std::is_sorted(cycle.events.begin(), cycle.events.end(), [](const CycleEvent& a, const CycleEvent& b) {
    if (a.branch != b.branch) return a.branch == Branch::loading;
    return a.branch == Branch::loading ? a.displacement < b.displacement : a.displacement > b.displacement;
  }));
  for (const CycleEvent& event : cycle.events) EXPECT_NE(event.from, event.to);
}

}  // namespace
}  // namespace bumpfoil
