#pragma once

#include <algorithm>
#include <cmath>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Of all increments, J.
inline double largest_work(const Cycle& cycle) {
  double work = 0.0;
  for (const Increment& increment : cycle.increments) work = std::max(work, std::abs(increment.work));
  return work;
}

/// Largest defect of W = E - E0 + D over the cycle, J.
inline double plain_balance_defect(const Cycle& cycle) {
  double defect = 0.0;
  const double initial = cycle.increments.front().elastic_energy;
  for (const Increment& increment : cycle.increments) {
    defect =
        std::max(defect, std::abs(increment.work - (increment.elastic_energy - initial) - increment.dissipated_energy));
  }
  return defect;
}

}  // namespace bumpfoil
