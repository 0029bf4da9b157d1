#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "bumpfoil/analysis/foil_model.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/contact/residual.hpp"
#include "support/bearing_cases.hpp"

namespace bumpfoil {
namespace {

/// Push and pull of a random bearing in a few large steps, every change of modes found by the interior point alone.
/// @return steps of the interior point
int run_alone(Case input, int steps) {
  const FoilModel model = make_bearing_model(input);
  NewtonSolver solver(model.problem, {.max_mode_updates = 0, .max_events = 0});
  ContactState previous = ContactState::unstressed(model.problem);
  ContactState state;
  const double phi = input.cycle.directions.front();
  int interior_steps = 0;
  for (int k = 0; k <= 2 * steps; ++k) {
    const double displacement = input.cycle.amplitude * (k <= steps ? k : 2 * steps - k) / steps;
    const ContactLoading loading = loading_at(model, {displacement * std::cos(phi), displacement * std::sin(phi)});
    const SolveReport report = solver.solve(loading, previous, state);
    EXPECT_TRUE(report.converged) << input.title << ", increment " << k;
    EXPECT_TRUE(
        contact_residuals(model.problem, model.problem.K.multiply(state.x), loading, previous.x, state).within())
        << input.title << ", increment " << k;
    interior_steps += report.outer_iterations;
    std::swap(previous, state);
  }
  return interior_steps;
}

TEST(InteriorPointAlone, SolvesRandomBearings) {
  for (std::uint64_t number = 0; number < 60; ++number) EXPECT_GT(run_alone(random_case(number), 6), 0);
}

/// Friction 0.5 at both interfaces, clearances of -10 um to 50 um.
TEST(InteriorPointAlone, SolvesThemWithStrongFrictionAndClearancesOfAnySign) {
  for (std::uint64_t number = 100; number < 160; ++number) {
    Case input = random_case(number);
    input.friction = {.top_bump = 0.5, .bump_sleeve = 0.5};
    input.bearing.radial_clearance = -10e-6 + 60e-6 * static_cast<double>(number - 100) / 59.0;
    EXPECT_GT(run_alone(input, 4), 0);
  }
}

TEST(InteriorPointAlone, SolvesThemWithTheFrame) {
  for (std::uint64_t number = 200; number < 230; ++number) {
    Case input = random_case(number);
    input.bump_foil.model = BumpFoilModel::frame;
    EXPECT_GT(run_alone(input, 4), 0);
  }
}

}  // namespace
}  // namespace bumpfoil
