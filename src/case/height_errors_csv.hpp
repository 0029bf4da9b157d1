#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Height errors of bumps, in m, from a CSV file as people and instruments write them: separated by commas, semicolons
/// or tabs, with cells in quotes or not, with decimal points or commas; comments behind # and other columns are left
/// out. One column has the name height_error_U or, for heights over the sleeve, height_U, with any unit U of length, or
/// "Height (U)". A column `bump` counts bumps from 1, in any order; without it there is a line for each from the weld
/// on.
/// @param heights  nominal heights of the bumps, m: heights are errors over these
/// @param rises    of their mid-surfaces, m: errors are smaller
/// @throws Error (input) listing every fault with its line; Error (file) if the file cannot be read.
std::vector<double> read_height_errors(const std::string& path, const std::vector<double>& heights,
                                       const std::vector<double>& rises);

}  // namespace bumpfoil
