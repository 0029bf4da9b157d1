#pragma once

#include <optional>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Runs a cycle in each direction of one sampled case after the other, for quantities alone. Nothing but the case
/// decides on them, to the last bit. What was built of the stiffness of one is kept for the next where heights and gaps
/// alone scatter.
class SampledCycleRunner {
 public:
  /// Numerical failures are reported in the result.
  /// @throws Error (input) if the case is invalid
  CycleResult run(const Case& sampled, const ProgressCallback& progress = {});

 private:
  SolverSettings settings_;
  std::optional<CycleRunner> runner_;
};

/// The same of a single case.
/// @return nothing if the case is invalid
std::optional<CycleResult> run_sampled_cycles(const Case& sampled, const ProgressCallback& progress = {});

}  // namespace bumpfoil
