#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"

namespace bumpfoil {

/// Height errors of `bumps` bumps from a CSV file with the columns bump,height_error_m: one line per bump, in any
/// order, bumps counted from 1, errors in m.
/// @throws Error (input) listing every fault with its line; Error (file) if the file cannot be read.
std::vector<double> read_height_errors(const std::string& path, int bumps);

}  // namespace bumpfoil
