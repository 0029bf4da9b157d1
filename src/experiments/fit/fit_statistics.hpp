#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "bumpfoil/experiments/fit/fit.hpp"

namespace bumpfoil {

/// Linearised least-squares statistics of the parameters at a minimum.
struct FitEstimate {
  Eigen::MatrixXd sensitivities;  ///< of weighted residuals by the parameters; priors last
  Eigen::VectorXd weights;        ///< of each residual: 1, or less for a robust one
  Eigen::VectorXd variances;      ///< of each residual, in squared units of its weight
  std::vector<bool> held;         ///< parameters at a bound
};

/// Covariance of the parameters: (J'WJ)^-1 J'WVWJ (J'WJ)^-1. NaN for parameters that the residuals do not determine,
/// and for those held.
Eigen::MatrixXd covariance_of(const FitEstimate& estimate);

/// Student's t that is exceeded with a probability of 2.5 %; to 0.1 % from 4 degrees of freedom on.
double student_975(int degrees_of_freedom);

/// Whether chi-square with this number of degrees of freedom exceeds what occurs by chance once in 30,000 fits (four
/// standard deviations, by the cube root of Wilson and Hilferty).
bool is_excessive(double chi_square, int degrees_of_freedom);

/// Combinations of parameters that the data poorly determine, in words: singular directions beyond `collinear` of the
/// sensitivities scaled to unit length, and parameters without effect.
/// @param sensitivities  of the data only, by the parameters, SI
/// @param collinearity   receives 1 / the smallest singular value
std::vector<std::string> hardly_told(const Eigen::MatrixXd& sensitivities, const std::vector<FitParameter>& parameters,
                                     const std::vector<std::string>& units, double& collinearity);

/// 1 / singular value above which [Brun2001] call parameters poorly identifiable (5 to 20).
inline constexpr double collinear = 10.0;

}  // namespace bumpfoil
