#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace bumpfoil {

/// Linear coefficients as arguments of ROSS's BearingElement: at each frequency, or of each speed at each frequency.
struct RossElement {
  std::vector<double> speeds;                       ///< of the rotor, rad/s, rising; none where one table is for all
  std::vector<double> frequencies;                  ///< rad/s, rising
  std::vector<Eigen::Matrix2d> stiffness, damping;  ///< N/m, N s/m; speed after speed, frequency after frequency
};

/// The table [bearing.element] of a TOML file. Coefficients at one frequency alone are numbers, without it; of several
/// speeds lists of lists, which have a row for each speed.
std::string toml_of(const RossElement& element);

/// A TOML float: one that looks like an integer would be read as one.
std::string toml_number(double value);

std::string toml_list(const std::vector<double>& values);

}  // namespace bumpfoil
