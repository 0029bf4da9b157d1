#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Linear coefficients as arguments of ROSS's BearingElement: of each speed at each frequency.
struct RossElement {
  std::vector<double> speeds;                       ///< of the rotor, rad/s, rising; none where one table is for all
  std::vector<double> frequencies;                  ///< rad/s, rising; none where each speed has its own
  std::vector<Eigen::Matrix2d> stiffness, damping;  ///< N/m, N s/m; speed after speed, frequency after frequency
};

/// The table [bearing.NAME] of a TOML file. An axis with one value alone is left out: coefficients over speed and
/// frequency are lists of lists, which have a row for each speed, those over one of the two are lists, and those over
/// neither are numbers.
std::string toml_of(const RossElement& element, std::string_view name = "element");

/// A TOML float: one that looks like an integer would be read as one.
std::string toml_number(double value);

std::string toml_list(const std::vector<double>& values);

}  // namespace bumpfoil
