#include <benchmark/benchmark.h>

#include <vector>

#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "support/long_bearing.hpp"

namespace bumpfoil {
namespace {

BearingModel long_bearing(int bumps) {
  return *make_bearing_foils(with_bumps(reference_case(), bumps));
}

/// Bumps 1, 2, 3 of every four carry load: two stick, one slips.
std::vector<ContactMode> mixed_modes(const BearingModel& foils) {
  std::vector<ContactMode> mode;
  for (int bump = 0; bump < foils.bumps(); ++bump) {
    const ContactMode m = bump % 4 == 0   ? ContactMode::open
                          : bump % 4 == 1 ? ContactMode::slip_forward
                                          : ContactMode::stick;
    const auto contacts = static_cast<std::size_t>(foils.contacts_per_block());
    mode.insert(mode.end(), contacts, m);
    if (m != ContactMode::open) mode[mode.size() - contacts] = ContactMode::stick;  // journal
  }
  return mode;
}

void report_per_bump(benchmark::State& bench) {
  bench.SetComplexityN(bench.range(0));
  // Printed in seconds per bump.
  bench.counters["per_bump"] = benchmark::Counter(
      static_cast<double>(bench.range(0)), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Assembly and factorisation from the first block on, and one solve.
void factor_and_solve(benchmark::State& bench) {
  const BearingModel foils = long_bearing(static_cast<int>(bench.range(0)));
  const std::unique_ptr<ModeSystem> system = make_mode_system(foils.problem);
  const ContactLoading loading = loading_under(foils, {.position = {4e-5, 0.0}});
  ContactState state = ContactState::unstressed(foils.problem);
  const Vector previous_x = state.x;
  std::vector<ContactMode> mode = mixed_modes(foils);
  for (auto _ : bench) {
    // A mode change in the first block: no part of the last factorisation can be reused.
    mode.front() = mode.front() == ContactMode::open ? ContactMode::stick : ContactMode::open;
    if (!system->set_modes(mode)) bench.SkipWithError("singular");
    system->solve(loading, previous_x, state);
    benchmark::DoNotOptimize(state.x.data());
  }
  report_per_bump(bench);
}
BENCHMARK(factor_and_solve)
    ->Arg(26)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity(benchmark::oN);

/// One solve with existing factors.
void solve(benchmark::State& bench) {
  const BearingModel foils = long_bearing(static_cast<int>(bench.range(0)));
  const std::unique_ptr<ModeSystem> system = make_mode_system(foils.problem);
  const ContactLoading loading = loading_under(foils, {.position = {4e-5, 0.0}});
  ContactState state = ContactState::unstressed(foils.problem);
  const Vector previous_x = state.x;
  if (!system->set_modes(mixed_modes(foils))) bench.SkipWithError("singular");
  for (auto _ : bench) {
    system->solve(loading, previous_x, state);
    benchmark::DoNotOptimize(state.x.data());
  }
  report_per_bump(bench);
}
BENCHMARK(solve)->Arg(26)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond)->Complexity(benchmark::oN);

}  // namespace
}  // namespace bumpfoil
