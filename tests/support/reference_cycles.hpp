#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// One cycle of tests/data/truss_cycles.json, computed by an independent dense prototype.
struct ReferenceCycle {
  std::string name;
  Case input;            ///< case to run with Bumpfoil for the same result
  Vector force_direct;   ///< N, per increment
  Vector force_cross;    ///< N, per increment
  double max_force{};    ///< N
  double loop_energy{};  ///< J
  Vector bump_loads;     ///< at the turning point, N
  Vector foot_loads;     ///< N
  Vector journal_loads;  ///< N
};

/// All cycles of the file, in its order.
const std::vector<ReferenceCycle>& reference_cycles();

/// Reference bearing with the truss constants of the file instead of identified ones: independent of the
/// identification. Friction 0.1, 100 steps, +X, -X, +Y, -Y.
Case case_with_given_constants();

}  // namespace bumpfoil
