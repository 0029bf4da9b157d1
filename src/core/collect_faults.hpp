#pragma once

#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Runs an action that may throw an Error, and adds its faults to previous ones, so that all are reported at once.
template <typename Action>
void collect_faults(std::vector<Fault>& faults, Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
  }
}

}  // namespace bumpfoil
