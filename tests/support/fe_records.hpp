#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// One push and pull of the bearing of solid elements: a row of tests/data/fe/full_bearing.json, which `make verify-fe`
/// writes.
struct FeCycle {
  std::string variant;  ///< what was varied; "held" makes the program's assumptions
  double friction_coefficient{};
  double direction{};    ///< rad
  int steps{};           ///< per branch
  double max_force{};    ///< N
  double cross_force{};  ///< at the turning point, N
  double loop_energy{};  ///< J
  Vector force_direct;   ///< per increment, N
  Vector bump_loads;     ///< at the turning point, N
};

/// All cycles of the file that came to their end.
const std::vector<FeCycle>& fe_cycles();

}  // namespace bumpfoil
