#pragma once

#include <string>
#include <vector>

namespace bumpfoil {

/// Reads measured deviations from a CSV file with the header `deviation` and one SI number per line.
/// @throws Error (input) with every error of the file; Error (file) if it cannot be read
std::vector<double> read_deviations(const std::string& path);

}  // namespace bumpfoil
