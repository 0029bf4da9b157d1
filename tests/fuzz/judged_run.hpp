#pragma once

#include <string>

#include "fuzz/drawn_case.hpp"

namespace bumpfoil {

/// What became of a case that was drawn.
struct Verdict {
  enum class End { refused, solved, failed, interrupted } end{};
  /// What is wrong with it: an answer that is said to be right and is not, or a failure without a word. Empty if
  /// nothing is.
  std::string wrong;
};

/// Runs a case for `budget` seconds at most, and judges the answer by what does not depend on the solver: residuals of
/// all equations, inequalities of the contacts, balances of forces, energies and masses.
Verdict judge_case(const DrawnCase& drawn, double budget);

}  // namespace bumpfoil
