#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace bumpfoil {

/// Residuals r(x) whose sum of squares is minimised over 0 <= x <= 1.
struct LeastSquares {
  /// Absent if the model fails. Called by several threads at once.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& x)> residuals;
  Eigen::Index robust{};  ///< number of first residuals that count linearly beyond `huber`
  std::optional<double> huber{};
};

/// Derivatives of the residuals by x.
struct Differences {
  Eigen::MatrixXd jacobian;  ///< of the residuals by x
  /// For each x: deviation of forward from backward differences, relative to their sum. Almost zero for smooth
  /// residuals; 1 if they jump and change by nothing else. Zero if only one difference exists.
  Eigen::VectorXd bends;
};

struct LeastSquaresMinimum {
  Eigen::VectorXd x;
  Eigen::VectorXd residuals;
  Differences differences;
  double cost{};  ///< sum of squares, robust ones reduced
  bool converged{};
};

/// Sum of squares, with robust residuals reduced.
double cost_of(const LeastSquares& problem, const Eigen::VectorXd& residuals);

/// Derivatives by central differences of difference_step, one-sided at bounds, on all cores. Absent if a residual is.
/// The response of foils is piecewise smooth: contact changes along a loop move with the parameters. The step is wide
/// enough to average over many of these kinks, and small compared with the uncertainty of a parameter due to noise.
inline constexpr double difference_step = 1e-3;
std::optional<Differences> differences_at(const LeastSquares& problem, const Eigen::VectorXd& x,
                                          const Eigen::VectorXd& residuals);

/// Minimises by the Levenberg-Marquardt method in a box (Ceres). It ends when a step lowers the sum by less than 1e-6
/// of it, or moves every parameter by less than 1e-7 of its bounds: kinks dominate below.
/// @param go_on  called after every step; false ends it
/// @return absent if there are no residuals, or no derivatives, at the start
std::optional<LeastSquaresMinimum> minimise(const LeastSquares& problem, const Eigen::VectorXd& start,
                                            const std::function<bool()>& go_on);

}  // namespace bumpfoil
