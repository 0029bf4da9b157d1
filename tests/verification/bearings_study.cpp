/// Not a test: solves random bearings and checks the results (docs/verification/drawn_bearings.md).
///
///     bearings_study COUNT [FROM]      bearings FROM (0) to FROM + COUNT - 1
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "support/drawn_bearings.hpp"

namespace bumpfoil {
namespace {

/// Both solvers are compared on one bearing of this many.
constexpr std::uint64_t compared_every = 10;

struct Tally {
  int unresolved{}, halved{}, wrong{}, small_increments{}, compared{}, refined{}, parted{};
  double apart{}, apart_refined{};
};

void tell(const char* solver, const SolverVerdict& verdict, std::uint64_t number, Tally& tally) {
  if (verdict.status != Status::converged) {
    ++tally.unresolved;
    fmt::print("{} {}: unresolved, {}\n", number, solver, explanation(verdict.status));
  }
  if (!verdict.wrong.empty()) {
    ++tally.wrong;
    fmt::print("{} {}: wrong, {}\n", number, solver, verdict.wrong);
  }
}

void tell(const BearingVerdict& verdict, std::uint64_t number, Tally& tally) {
  tell("newton", verdict.newton, number, tally);
  tell("events", verdict.events, number, tally);
  if (verdict.newton.substeps > 0) {
    ++tally.halved;
    fmt::print("{} newton: halved, {} substeps\n", number, verdict.newton.substeps);
  }
  if (verdict.events.substeps > 0) {
    ++tally.small_increments;
    fmt::print("{} events: {} small increments\n", number, verdict.events.substeps);
  }
  if (!verdict.apart) return;
  ++tally.compared;
  tally.apart = std::max(tally.apart, *verdict.apart);
  if (*verdict.apart <= agreement) return;
  ++tally.refined;
  if (verdict.apart_refined) tally.apart_refined = std::max(tally.apart_refined, *verdict.apart_refined);
  if (verdict.apart_refined.value_or(HUGE_VAL) <= agreement) return;
  ++tally.parted;
  fmt::print("{} solvers part: {:.2g} of the largest force, {:.2g} with smaller increments\n", number, *verdict.apart,
             verdict.apart_refined.value_or(HUGE_VAL));
}

void study(std::uint64_t count, std::uint64_t from) {
  std::vector<BearingVerdict> verdicts(count);
  run_in_parallel(count, available_threads(), [&](std::size_t i, const ProgressCallback&) {
    verdicts[i] = check_bearing(drawn_bearing(from + i), (from + i) % compared_every == 0);
  });
  Tally tally;
  for (std::size_t i = 0; i < count; ++i) tell(verdicts[i], from + i, tally);
  fmt::print(
      "bearings {} to {}: {} unresolved, {} halved, {} wrong, {} with small increments of events\n"
      "{} compared: {:.2g} apart at most; {} of them refined, {:.2g} apart then; solvers part in {}\n",
      from, from + count - 1, tally.unresolved, tally.halved, tally.wrong, tally.small_increments, tally.compared,
      tally.apart, tally.refined, tally.apart_refined, tally.parted);
}

}  // namespace
}  // namespace bumpfoil

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    fmt::print(stderr, "usage: bearings_study COUNT [FROM]\n");
    return 2;
  }
  bumpfoil::study(std::strtoull(argv[1], nullptr, 10), argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 0);
  return 0;
}
