#pragma once

#include <string>

#include "bumpfoil/rotor/matrices.hpp"

namespace bumpfoil {

/// Reads a rotor from a JSON file with M, C, G and K (lists of rows), and the lists bearing and station, of objects
/// with name, z, x and y, see RotorMatrices.
/// @throws Error (file) if the file cannot be read; Error (input) with all errors in it
RotorMatrices read_rotor_matrices(const std::string& path);

}  // namespace bumpfoil
