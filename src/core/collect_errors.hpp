#pragma once

#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Runs an action that may throw an Error, and adds its errors to previous ones, so that all are reported at once.
template <typename Action>
void collect_errors(std::vector<InputError>& errors, Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    errors.insert(errors.end(), error.errors().begin(), error.errors().end());
  }
}

}  // namespace bumpfoil
