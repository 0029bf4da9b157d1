#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace bumpfoil {

/// Residuals r(x) whose squares are to be least over 0 <= x <= 1.
struct LeastSquares {
  /// Absent where there are none. Called by several threads at once.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& x)> residuals;
  Eigen::Index robust{};  ///< the first so many count linearly beyond `huber`
  std::optional<double> huber{};
};

/// How residuals change with x.
struct Differences {
  Eigen::MatrixXd jacobian;  ///< of the residuals by x
  /// Of each of x: how far differences up and down are from each other, in parts of their sum. Next to nothing where
  /// the residuals are smooth; 1 where they jump, and change by nothing else. Zero where there are not both.
  Eigen::VectorXd bends;
};

struct LeastSquaresMinimum {
  Eigen::VectorXd x;
  Eigen::VectorXd residuals;
  Differences differences;
  double cost{};  ///< sum of their squares, or what counts of them
  bool converged{};
};

/// What counts of a sum of squares.
double cost_of(const LeastSquares& problem, const Eigen::VectorXd& residuals);

/// Derivatives by central differences of difference_step, at bounds one-sided, on all cores. Absent where a residual
/// is. The response of foils is smooth in pieces: contacts that change along a loop are elsewhere for other parameters.
/// The step is wide enough to go over many of these kinks, and narrow beside what noise leaves open of a parameter.
inline constexpr double difference_step = 1e-3;
std::optional<Differences> differences_at(const LeastSquares& problem, const Eigen::VectorXd& x,
                                          const Eigen::VectorXd& residuals);

/// Minimises by the method of Levenberg and Marquardt in a box (Ceres). It ends when a step lowers the sum by less than
/// 1e-6 of it, or moves no parameter by more than 1e-7 of its bounds: below, kinks decide.
/// @param go_on  asked after every step; false ends it
/// @return absent where there are no residuals at the start, or no derivatives
std::optional<LeastSquaresMinimum> minimise(const LeastSquares& problem, const Eigen::VectorXd& start,
                                            const std::function<bool()>& go_on);

}  // namespace bumpfoil
