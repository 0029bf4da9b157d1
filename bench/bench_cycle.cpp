#include <benchmark/benchmark.h>

#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/contact/newton.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "support/long_bearing.hpp"

namespace bumpfoil {
namespace {

/// Reference bearing, friction 0.1, +X, 100 steps per branch.
Case reference_push() {
  Case input = reference_case();
  input.settings.get<CycleSettings>().directions = {0.0};
  return input;
}

/// One increment of the default solver, averaged over the reference cycle, results not recorded.
void increment(benchmark::State& bench) {
  const Case input = reference_push();
  const BearingModel foils = *make_bearing_foils(input);
  NewtonSolver solver(foils.problem);
  std::vector<ContactLoading> loadings;
  const auto& cycle = input.settings.get<CycleSettings>();
  for (int k = 0; k <= 2 * cycle.steps; ++k) {
    const int from_centre = k <= cycle.steps ? k : 2 * cycle.steps - k;
    const double displacement = cycle.amplitude.value * from_centre / cycle.steps;
    loadings.push_back(loading_under(foils, {.position = {displacement, 0.0}}));
  }
  const ContactState unstressed = ContactState::unstressed(foils.problem);
  ContactState previous = unstressed;
  ContactState state = unstressed;
  std::size_t k = 0;
  std::int64_t linear_solves = 0;
  for (auto _ : bench) {
    if (k == 0) previous = unstressed;
    const SolveReport report = solver.solve(loadings[k], previous, state);
    if (!report.converged()) bench.SkipWithError("an increment failed");
    linear_solves += report.cost.iterations;
    std::swap(previous, state);
    k = (k + 1) % loadings.size();
  }
  bench.counters["linear_solves"] =
      benchmark::Counter(static_cast<double>(linear_solves), benchmark::Counter::kAvgIterations);
}
// Multiples of the 201 increments of a cycle, so that each run has the same mix.
BENCHMARK(increment)->Unit(benchmark::kMicrosecond)->Iterations(benchmark::IterationCount{201} * 20);

/// A complete cycle without set-up: increments, records, derived quantities.
void run_cycle(benchmark::State& bench, Case input, SolverName solver) {
  input.solver.name = solver;
  SolveCost cost;
  for (auto _ : bench) {
    const CycleResult result = run_cycles(input);
    if (!result.converged()) bench.SkipWithError("the cycle failed");
    bench.SetIterationTime(result.cycles.front().wall_time);
    cost = result.cycles.front().cost;
  }
  bench.counters["linear_solves"] = cost.iterations;
  bench.counters["factorisations"] = cost.factorisations;
}

void reference_cycle(benchmark::State& bench, SolverName solver) {
  run_cycle(bench, reference_push(), solver);
}
BENCHMARK_CAPTURE(reference_cycle, newton, SolverName::newton)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reference_cycle, events, SolverName::events)->UseManualTime()->Unit(benchmark::kMillisecond);

/// The same cycle for its quantities only, as in an ensemble: foils and runner are made once.
void cycle_quantities(benchmark::State& bench, SolverName solver) {
  Case input = reference_push();
  input.solver.name = solver;
  CycleRunner runner(make_bearing_foils(input), input.solver);
  for (auto _ : bench) {
    const Cycle cycle = runner.run(0.0, input.settings.get<CycleSettings>(), Recording::quantities);
    if (!cycle.converged()) bench.SkipWithError("the cycle failed");
    benchmark::DoNotOptimize(cycle.loop_energy);
  }
}
BENCHMARK_CAPTURE(cycle_quantities, newton, SolverName::newton)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(cycle_quantities, events, SolverName::events)->Unit(benchmark::kMillisecond);

/// The additional cost per sample of an ensemble with different foils.
void make_foils_and_runner(benchmark::State& bench) {
  const Case input = reference_push();
  for (auto _ : bench) {
    CycleRunner runner(make_bearing_foils(input), input.solver);
    benchmark::DoNotOptimize(&runner);
  }
}
BENCHMARK(make_foils_and_runner)->Unit(benchmark::kMicrosecond);

void cycle_of_steps(benchmark::State& bench, SolverName solver) {
  Case input = reference_push();
  input.settings.get<CycleSettings>().steps = static_cast<int>(bench.range(0));
  run_cycle(bench, input, solver);
}
void each_number_of_steps(benchmark::internal::Benchmark* bench) {
  bench->RangeMultiplier(4)->Range(25, 1600)->UseManualTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(cycle_of_steps, newton, SolverName::newton)->Apply(each_number_of_steps);
BENCHMARK_CAPTURE(cycle_of_steps, events, SolverName::events)->Apply(each_number_of_steps);

/// 20 steps per branch: both the number of events and the cost of each grow with the number of bumps.
void cycle_of_bumps(benchmark::State& bench, SolverName solver) {
  Case input = with_bumps(reference_push(), static_cast<int>(bench.range(0)));
  input.settings.get<CycleSettings>().steps = 20;
  run_cycle(bench, input, solver);
}
void each_number_of_bumps(benchmark::internal::Benchmark* bench) {
  for (const int bumps : {26, 52, 104, 208}) bench->Arg(bumps);
  bench->UseManualTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(cycle_of_bumps, newton, SolverName::newton)->Apply(each_number_of_bumps);
BENCHMARK_CAPTURE(cycle_of_bumps, events, SolverName::events)->Apply(each_number_of_bumps);

/// Many more bumps than in any real bearing: seconds each, so one cycle per repetition.
void many_bumps(benchmark::internal::Benchmark* bench) {
  bench->Arg(1000)->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(cycle_of_bumps, newton, SolverName::newton)->Apply(many_bumps)->Arg(10000);
BENCHMARK_CAPTURE(cycle_of_bumps, events, SolverName::events)->Apply(many_bumps);

}  // namespace
}  // namespace bumpfoil
