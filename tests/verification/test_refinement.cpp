#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bumpfoil/analysis/cycle.hpp"
#include "support/bearing_cases.hpp"
#include "support/reference_cycles.hpp"

namespace bumpfoil {
namespace {

/// Changes of a quantity from one number of steps to twice as many.
std::vector<double> changes(const std::vector<double>& values) {
  std::vector<double> out;
  for (std::size_t i = 1; i < values.size(); ++i) out.push_back(std::abs(values[i] - values[i - 1]));
  return out;
}

/// Finer increments lead to a limit: forces and loop energy change less and less, at first order or better over the
/// whole range of 25 to 400 steps.
TEST(Refinement, ConvergesInEveryDirection) {
  Case input = case_with_given_constants();
  for (const double direction : input.cycle.directions) {
    std::vector<double> force, half_way_back, loop;
    for (const int steps : {25, 50, 100, 200, 400}) {
      input.cycle.steps = steps;
      const Cycle cycle = run_single_cycle(input, direction);
      ASSERT_TRUE(cycle.converged);
      force.push_back(cycle.turning_point->max_force / 800.0);
      half_way_back.push_back(cycle.increments[static_cast<std::size_t>(steps + steps / 5)].force_direct / 800.0);
      loop.push_back(*cycle.loop_energy / 5e-3);
    }
    for (const std::vector<double>& quantity : {force, half_way_back, loop}) {
      const std::vector<double> d = changes(quantity);
      EXPECT_LT(d.back(), 0.2 * d.front() + 1e-9) << "direction " << direction;
      EXPECT_LT(d.back(), 2e-3) << "direction " << direction;
    }
  }
}

}  // namespace
}  // namespace bumpfoil
