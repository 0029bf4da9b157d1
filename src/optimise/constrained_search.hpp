#pragma once

#include <Eigen/Core>
#include <functional>

namespace bumpfoil {

/// A function that is to be least over 0 <= x <= 1 with limits that are not to be positive.
struct SearchProblem {
  Eigen::Index limits{};
  /// Gives the function and its limits at x; false ends the search.
  std::function<bool(const Eigen::VectorXd& x, double& aim, Eigen::VectorXd& limits)> evaluate;
};

enum class SearchEnd {
  tolerance,
  rounding,  ///< steps are not told from round-off
  stopped,   ///< by the function
};

/// Searches from a start without derivatives: by linear models of the function and its limits over a simplex that
/// shrinks from `step` to `tolerance` (COBYLA of NLopt).
SearchEnd search_constrained(const SearchProblem& problem, const Eigen::VectorXd& start, double step, double tolerance);

}  // namespace bumpfoil
