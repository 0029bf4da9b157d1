#pragma once

#include <Eigen/Core>
#include <functional>

namespace bumpfoil {

/// A function to be minimised over 0 <= x <= 1, with constraints that must not be positive.
struct SearchProblem {
  Eigen::Index limits{};
  /// Evaluates the function and its constraints at x; false ends the search.
  std::function<bool(const Eigen::VectorXd& x, double& aim, Eigen::VectorXd& limits)> evaluate;
};

enum class SearchEnd {
  tolerance,
  round_off,  ///< steps are at round-off level
  stopped,    ///< by the function
};

/// Derivative-free search from a start: linear models of the function and its constraints over a simplex that shrinks
/// from `step` to `tolerance` (COBYLA of NLopt).
SearchEnd search_constrained(const SearchProblem& problem, const Eigen::VectorXd& start, double step, double tolerance);

}  // namespace bumpfoil
