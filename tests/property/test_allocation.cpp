#include <gtest/gtest.h>
#include <malloc.h>

#include <cstddef>
#include <memory>

#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "property/counted_allocator.hpp"
#include "support/random_problem.hpp"

#ifdef BUMPFOIL_COUNTS_ALLOCATIONS

namespace bumpfoil {
namespace {

TEST(Allocation, IsCounted) {
  const long before = allocations;
  const Vector some = Vector::Ones(100);
  EXPECT_EQ(some.sum(), 100.0);
  EXPECT_GE(allocations - before, 1);
}

/// Allocations of a second solve, after a first one under another loading.
struct Counted {
  long allocations{};
  SolveReport report;
};

Counted count_second_solve(const RandomProblem& random) {
  NewtonSolver solver(random.problem);
  const ContactState start = ContactState::unstressed(random.problem);
  ContactState previous = start;
  ContactState state = start;
  EXPECT_TRUE(solver.solve(random.first, start, previous).converged());
  state = previous;
  const long before = allocations;
  Counted counted;
  counted.report = solver.solve(random.second, previous, state);
  counted.allocations = allocations - before;
  return counted;
}

/// Increments of a long simulation must not allocate: the first solve allocates all storage.
TEST(Allocation, NewtonSolverAllocatesOnlyInItsFirstSolve) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Counted counted = count_second_solve(make_random_problem(seed, 12, 6, 0.3));
    EXPECT_TRUE(counted.report.converged());
    EXPECT_EQ(counted.allocations, 0) << "seed " << seed;
  }
}

/// The same if the event path and the interior point are needed: friction coefficient 1.
TEST(Allocation, NeitherDoItsOtherMethods) {
  int helped = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Counted counted = count_second_solve(make_random_problem(seed, 20, 6, 1.0));
    if (counted.report.cost.outer_iterations > 0) ++helped;
    EXPECT_EQ(counted.allocations, 0) << "seed " << seed << ", " << counted.report.cost.outer_iterations << " steps";
  }
  EXPECT_GE(helped, 1);
}

/// Ensembles keep a runner per thread and share the foils: a runner only holds its workspace; with the event-driven
/// solver also the contact tableau and its inputs, four times about 150 by 130 numbers.
TEST(Allocation, ARunnerHoldsLittle) {
  Case input = reference_case();
  const SharedBearing foils = make_bearing_foils(input);
  const std::pair<SolverName, std::size_t> solvers[] = {{SolverName::newton, 220'000U},
                                                        {SolverName::events, 1'000'000U}};
  for (const auto& [solver, most] : solvers) {
    const std::size_t before = mallinfo2().uordblks;
    const auto runner = std::make_unique<CycleRunner>(foils, SolverSettings{.name = solver, .uzawa = {}});
    EXPECT_TRUE(runner->run(0.0, input.settings.get<CycleSettings>(), Recording::quantities).converged());
    EXPECT_LT(mallinfo2().uordblks + mallinfo2().hblkhd - before, most);
    EXPECT_GT(mallinfo2().uordblks - before, 20'000U);  // the factors of 26 blocks alone take more
  }
}

}  // namespace
}  // namespace bumpfoil

#endif
