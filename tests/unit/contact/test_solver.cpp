#include "bumpfoil/contact/solver.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/contact/newton.hpp"
#include "support/toy_problems.hpp"

namespace bumpfoil {
namespace {

TEST(SolveCost, AddsUpEntryByEntry) {
  SolveCost sum{.iterations = 1, .factorisations = 2, .outer_iterations = 3};
  sum += {.iterations = 10, .factorisations = 20, .outer_iterations = 30};
  EXPECT_EQ(sum, (SolveCost{.iterations = 11, .factorisations = 22, .outer_iterations = 33}));
}

TEST(SolveReport, ConvergedIsOneStatusOfMany) {
  SolveReport report;
  for (std::size_t i = 0; i < enum_names<Status>.size(); ++i) {
    report.status = static_cast<Status>(i);
    EXPECT_EQ(report.converged(), i == 0U);
  }
}

TEST(SolverBounds, AreThoseOfTheResidualsForExactSolvers) {
  const NewtonSolver newton(toy::dragged_block());
  EXPECT_EQ(newton.bounds().force, 1e-9);
  EXPECT_EQ(newton.bounds().displacement, 1e-12);
}

}  // namespace
}  // namespace bumpfoil
