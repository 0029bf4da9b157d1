#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "support/bearing_cases.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

/// Largest difference of the force vectors of two cycles at their common increments, N.
double largest_difference(const Cycle& coarse, const Cycle& fine) {
  const int ratio = fine.steps / coarse.steps;
  double largest = 0.0;
  for (const Increment& a : coarse.increments) {
    const Increment& b = fine.increments[static_cast<std::size_t>(a.index * ratio)];
    largest = std::max(largest, std::hypot(a.force_direct - b.force_direct, a.force_cross - b.force_cross));
  }
  return largest;
}

/// Slip is straight within an increment: results depend on the increments to first order and converge, here to those of
/// 1600 steps.
TEST(Refinement, ConvergesAtFirstOrderInEveryDirection) {
  Case input = case_with_given_constants();
  for (const double direction : input.settings.get<CycleSettings>().directions) {
    input.settings.get<CycleSettings>().steps = 1600;
    const Cycle fine = run_single_cycle(input, direction);
    ASSERT_TRUE(fine.converged());
    double last_loop_error = *fine.loop_energy;
    for (const int steps : {25, 100, 400}) {
      input.settings.get<CycleSettings>().steps = steps;
      const Cycle cycle = run_single_cycle(input, direction);
      ASSERT_TRUE(cycle.converged());
      // Single forces scatter below this bound, as contacts change in one increment or the next.
      EXPECT_LT(largest_difference(cycle, fine), 0.7 * fine.turning_point->max_force / steps)
          << "direction " << direction << ", " << steps << " steps";
      // First order: a quarter each time, plus a margin for the same reason.
      const double loop_error = std::abs(*cycle.loop_energy - *fine.loop_energy);
      EXPECT_LT(loop_error, 0.45 * last_loop_error) << "direction " << direction << ", " << steps << " steps";
      last_loop_error = loop_error;
    }
    EXPECT_LT(last_loop_error, 0.003 * *fine.loop_energy) << "direction " << direction;
  }
}

}  // namespace
}  // namespace bumpfoil
