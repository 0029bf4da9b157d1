#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// Linear coefficients as arguments of ROSS's BearingElement, for each speed and frequency.
struct RossElement {
  std::vector<double> speeds;                       ///< of the rotor, rad/s, increasing; empty: one table for all
  std::vector<double> frequencies;                  ///< rad/s, increasing; empty if each speed has its own
  std::vector<Eigen::Matrix2d> stiffness, damping;  ///< N/m, N s/m; speed after speed, frequency after frequency
};

/// The table [bearing.NAME] of a TOML file. An axis with a single value is omitted: coefficients over speed and
/// frequency are lists of lists, one row per speed; over one of the two, lists; over neither, numbers.
std::string toml_of(const RossElement& element, std::string_view name = "element");

/// A TOML float: without a decimal point, TOML would read an integer.
std::string toml_number(double value);

std::string toml_list(const std::vector<double>& values);

}  // namespace bumpfoil
