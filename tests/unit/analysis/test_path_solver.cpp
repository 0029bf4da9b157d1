#include "bumpfoil/analysis/path_solver.hpp"

#include <gtest/gtest.h>

#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

/// Block pressed by 40 N (20 N of friction) and pulled by 30 N against a spring of 2 N/um.
struct Pulled {
  explicit Pulled(SolverName name)
      : problem(toy::dragged_block()),
        solver({.name = name, .uzawa = {}}, problem),
        state(ContactState::unstressed(problem)) {
    const ContactState unstressed = state;
    EXPECT_TRUE(solver.assemble(toy::pull(0.0, 40.0), unstressed, state).converged);
    solver.set_out(toy::pull(0.0, 40.0), toy::pull(30.0, 40.0), state);
    report = solver.advance_to(
        1.0, state, [this](const ContactState&, const ContactState&) { ++parts; }, events);
  }

  ContactProblem problem;
  PathSolver solver;
  ContactState state;
  IncrementReport report;
  int parts{};
  std::vector<ContactEvent> events;
};

TEST(PathSolver, NewtonTakesTheIncrementInOnePart) {
  const Pulled pulled(SolverName::newton);
  EXPECT_TRUE(pulled.report.solve.converged);
  EXPECT_FALSE(pulled.solver.follows_events());
  EXPECT_EQ(pulled.parts, 1);
  EXPECT_TRUE(pulled.events.empty());
  EXPECT_NEAR(pulled.state.x[0], 5e-6, 1e-17);
}

TEST(PathSolver, EventsReportThePartsAndWhatSeparatesThem) {
  const Pulled pulled(SolverName::events);
  EXPECT_TRUE(pulled.report.solve.converged);
  EXPECT_TRUE(pulled.solver.follows_events());
  EXPECT_EQ(pulled.parts, 2);
  ASSERT_EQ(pulled.events.size(), 1U);
  EXPECT_NEAR(pulled.events[0].fraction, 20.0 / 30.0, 1e-12);
  EXPECT_NEAR(pulled.state.x[0], 5e-6, 1e-17);
}

TEST(PathSolver, UzawaComesCloseToTheExactState) {
  const Pulled pulled(SolverName::uzawa);
  EXPECT_TRUE(pulled.report.solve.converged);
  EXPECT_NEAR(pulled.state.x[0], 5e-6, 0.01 * 5e-6);  // its friction is regularised
  EXPECT_NE(pulled.state.x[0], 5e-6);
}

}  // namespace
}  // namespace bumpfoil
