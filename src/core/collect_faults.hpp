#pragma once

#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Does what may throw an Error, and adds its faults to those of what came before, so that all are told at once.
template <typename Action>
void collect_faults(std::vector<Fault>& faults, Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
  }
}

}  // namespace bumpfoil
