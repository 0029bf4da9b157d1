#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// One push and pull of the solid-element bearing: a row of tests/data/fe/full_bearing.json, written by `make
/// verify-fe`.
struct FeCycle {
  std::string variant;  ///< the variation; "held" makes the program's assumptions
  double friction_coefficient{};
  double direction{};    ///< rad
  int steps{};           ///< per branch
  double max_force{};    ///< N
  double cross_force{};  ///< at the turning point, N
  double loop_energy{};  ///< J
  Vector force_direct;   ///< per increment, N
  Vector bump_loads;     ///< at the turning point, N
};

/// One strip of solid elements, pressed by 20 um in 20 steps and released: a row of tests/data/fe/strips.json.
struct FeStrip {
  int bumps{};
  double friction_coefficient{};
  bool top_foil{};
  bool large_displacements{};
  bool contact_at_nodes{};  ///< otherwise that of CalculiX
  double max_force{};       ///< N
  double loop_energy{};     ///< J
  Vector bump_loads;        ///< of the plate above each bump at full compression, N
};

/// All completed strips of the file.
const std::vector<FeStrip>& fe_strips();

/// All completed cycles of the file.
const std::vector<FeCycle>& fe_cycles();

}  // namespace bumpfoil
