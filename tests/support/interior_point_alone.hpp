#pragma once

#include <string>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

struct InteriorPointRun {
  int increments{};
  int steps{};          ///< of the interior point
  std::string failure;  ///< empty if every increment converged within the bounds of contact_residuals
};

/// Push and pull in a few large increments along the first direction, every change of modes found by the interior point
/// of `newton` alone: no rounds of mode changes before it, no path from event to event.
/// @param increments  each way
InteriorPointRun run_interior_point_alone(const Case& input, int increments);

}  // namespace bumpfoil
