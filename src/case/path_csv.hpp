#pragma once

#include <string>

#include "bumpfoil/model/control.hpp"

namespace bumpfoil {

/// Journal path from a CSV file with the columns x_m,y_m (positions) or force_x_N,force_y_N (loads), one point per
/// line, in SI.
/// @throws Error (input) listing every error with its line; Error (file) if the file cannot be read.
PathPoints read_path(const std::string& path);

}  // namespace bumpfoil
