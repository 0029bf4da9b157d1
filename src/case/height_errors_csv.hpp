#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Height errors of bumps, in m, from a CSV file as written by people and instruments: separated by commas, semicolons
/// or tabs, with or without quotes, with decimal points or commas; comments after # and other columns are ignored. One
/// column is named height_error_U or, for heights above the sleeve, height_U, with any unit U of length, or "Height
/// (U)". A column `bump` gives bump numbers from 1, in any order; without it there is one line per bump from the weld
/// on.
/// @param heights  nominal heights of the bumps, m: reference of the errors
/// @param rises    of their mid-surfaces, m: errors must be smaller
/// @throws Error (input) listing every error with its line; Error (file) if the file cannot be read.
std::vector<double> read_height_errors(const std::string& path, const std::vector<double>& heights,
                                       const std::vector<double>& rises);

}  // namespace bumpfoil
