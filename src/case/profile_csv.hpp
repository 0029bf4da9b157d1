#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Deviations of a radius around the circumference, in m, from a CSV file as written by instruments (separators and
/// numbers as for read_height_errors): one line per equal angle step from X towards Y. One column is named deviation_U,
/// with any unit U of length. A column `angle_deg` must contain these angles, from 0 in equal steps to one step before
/// 360.
/// @throws Error (input) listing every error with its line; Error (file) if the file cannot be read.
std::vector<double> read_profile(const std::string& path);

}  // namespace bumpfoil
