#pragma once

#include <string>

#include "fuzz/drawn_case.hpp"

namespace bumpfoil {

/// Outcome of a random case.
struct Verdict {
  enum class End { refused, solved, failed, interrupted } end{};
  /// The error: a wrong result reported as converged, or a failure without a message. Empty if there is none.
  std::string wrong;
};

/// Runs a case for at most `budget` seconds, and checks the results by solver-independent criteria: residuals of all
/// equations, inequalities of the contacts, balances of forces, energies and masses.
Verdict check_case(const DrawnCase& drawn, double budget);

}  // namespace bumpfoil
