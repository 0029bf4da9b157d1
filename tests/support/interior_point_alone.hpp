#pragma once

#include <string>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

struct InteriorPointRun {
  int increments{};
  int steps{};          ///< of the interior point
  std::string failure;  ///< empty if every increment converged within the bounds of contact_residuals
};

/// Push and pull in a few large increments along the first direction, with all mode changes found by the interior point
/// of `newton`: without preceding rounds of mode changes or event paths.
/// @param increments  each way
InteriorPointRun run_interior_point_alone(const Case& input, int increments);

}  // namespace bumpfoil
