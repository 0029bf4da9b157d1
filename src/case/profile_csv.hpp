#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Deviations of a radius around the circumference, in m, from a CSV file as instruments write them (separators and
/// numbers as of read_height_errors): a line for each of equal angles from X on towards Y. One column has the name
/// deviation_U, with any unit U of length. A column `angle_deg` must say the same angles, from 0 on in equal steps
/// to one step before 360.
/// @throws Error (input) listing every fault with its line; Error (file) if the file cannot be read.
std::vector<double> read_profile(const std::string& path);

}  // namespace bumpfoil
