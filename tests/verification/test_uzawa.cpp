#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bumpfoil/analysis/bearing_model.hpp"
#include "bumpfoil/contact/uzawa.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "support/uzawa_comparison.hpp"

/// The augmented Lagrangian solver against the exact one: docs/verification/uzawa.md.
namespace bumpfoil {
namespace {

class UzawaDefaults : public testing::TestWithParam<std::tuple<double, bool>> {};

TEST_P(UzawaDefaults, AreCloseToTheExactSolver) {
  const auto [friction, scattered] = GetParam();
  Case input = scattered ? scattered_uzawa_study_case() : uzawa_study_case();
  input.friction = {.top_bump = friction, .bump_sleeve = friction};
  const UzawaDeviation deviation = compare_uzawa(input, run_cycles(input), UzawaParameters());
  EXPECT_EQ(deviation.failures, 0);
  EXPECT_EQ(deviation.halvings, 0);
  // What is asked for is 0.5 % in force and 3 % in loop energy; the page states less than 0.01 % and 0.02 %.
  EXPECT_LT(deviation.max_force, 1e-4);
  EXPECT_LT(deviation.loop_energy, 3e-4);
  RecordProperty("force", fmt::format("{:.2g}", deviation.max_force));
  RecordProperty("loop_energy", fmt::format("{:.2g}", deviation.loop_energy));
}

INSTANTIATE_TEST_SUITE_P(Reference, UzawaDefaults, testing::Combine(testing::Values(0.0, 0.1), testing::Bool()));

struct Row {
  UzawaParameters parameters;
  double force, loop_energy;  ///< of the page's table: worst of both bearings and all directions
};

/// The rows with errors that are large enough to be told from the tolerances of the solver, in the direction and for
/// the bearing that show the worst of them.
class UzawaStudy : public testing::TestWithParam<Row> {};

TEST_P(UzawaStudy, ShowsThePagesErrors) {
  const Row& row = GetParam();
  UzawaDeviation all;
  for (const Case& input : {uzawa_study_case(), scattered_uzawa_study_case()}) {
    all = worst(all, compare_uzawa(input, run_cycles(input), row.parameters));
  }
  EXPECT_EQ(all.failures, 0);
  // The page prints three decimals of a per cent.
  EXPECT_NEAR(all.max_force, row.force, 0.02 * row.force);
  EXPECT_NEAR(all.loop_energy, row.loop_energy, 0.02 * row.loop_energy);
}

INSTANTIATE_TEST_SUITE_P(Rows, UzawaStudy,
                         testing::Values(Row{{.eps_f = 1e7}, 1.477e-2, 4.580e-2},
                                         Row{{.eps_r = 1e8}, 3.752e-2, 6.982e-2},
                                         Row{{.tau_f = 1e-8}, 0.297e-2, 1.001e-2}));

TEST(UzawaHold, NothingCreepsInABearingThatIsHeld) {
  const BearingModel model = make_bearing_model(uzawa_study_case());
  const UzawaParameters given;
  UzawaSolver solver(model.problem,
                     {.eps_alm = given.eps_alm, .eps_f = given.eps_f, .eps_r = given.eps_r, .tau_f = given.tau_f});
  ContactState state = ContactState::unstressed(model.problem);
  ContactLoading loading;
  for (int step = 0; step <= 50; ++step) {
    const ContactState previous = state;
    loading = loading_at(model, Eigen::Vector2d(0.0, step * 1e-6));
    ASSERT_TRUE(solver.solve(loading, previous, state).converged);
  }
  const ContactState reached = state;
  for (int increment = 0; increment < 100; ++increment) {
    const ContactState previous = state;
    ASSERT_TRUE(solver.solve(loading, previous, state).converged);
  }
  const Vector crept =
      tangential_displacements(model.problem, state.x) - tangential_displacements(model.problem, reached.x);
  // Springs started anew at each increment would go some F / eps_f = 1 N / 1e10 N/m a hundred times over, 1e-8 m; what
  // is left is the multipliers' tolerance, 1e-6 of 100 N over the 2 MN/m of a bump.
  EXPECT_LT(crept.cwiseAbs().maxCoeff(), 1e-10);
  const Vector lost = state.friction_force - reached.friction_force;
  EXPECT_LT(lost.cwiseAbs().maxCoeff(), 1e-4 * reached.friction_force.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace bumpfoil
