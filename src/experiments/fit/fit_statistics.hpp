#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"

namespace bumpfoil {

/// Linearised least-squares statistics of the parameters at a minimum.
struct FitEstimate {
  Eigen::MatrixXd sensitivities;  ///< of residuals over their weights' deviations, by the parameters; priors last
  Eigen::VectorXd weights;        ///< what counts of each residual: 1, or less of one that is robust
  Eigen::VectorXd variances;      ///< of each residual, in units of its weight's
  std::vector<bool> held;         ///< parameters at a bound
};

/// Covariance of the parameters: (J'WJ)^-1 J'WVWJ (J'WJ)^-1. Not a number where the residuals do not tell a parameter,
/// and of those that are held.
Eigen::MatrixXd covariance_of(const FitEstimate& estimate);

/// Student's t that is exceeded with a probability of 2.5 %; to 0.1 % from 4 degrees of freedom on.
double student_975(int degrees_of_freedom);

/// Whether chi-square with so many degrees of freedom is larger than chance makes it in 30,000 fits (four standard
/// deviations, by the cube root of Wilson and Hilferty).
bool is_excessive(double chi_square, int degrees_of_freedom);

/// Combinations of parameters that the data hardly tell, in words: of sensitivities scaled to length 1 the singular
/// directions beyond `collinear`, and parameters that change nothing.
/// @param sensitivities  of the data alone, by the parameters, SI
/// @param collinearity   receives 1 / the smallest singular value
std::vector<std::string> hardly_told(const Eigen::MatrixXd& sensitivities, const std::vector<FitParameter>& parameters,
                                     const std::vector<std::string>& units, double& collinearity);

/// 1 / singular value from which on [Brun2001] call parameters poorly identifiable (5 to 20).
inline constexpr double collinear = 10.0;

}  // namespace bumpfoil
