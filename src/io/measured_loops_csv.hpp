#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/analysis/cycle_quantities.hpp"

namespace bumpfoil {

/// A measured loop, and of which cycle it is.
struct MeasuredLoop {
  std::optional<double> at{};  ///< direction in degrees, or number of a strip's cycle; absent where the file has none
  std::vector<LoadingCurve::Point> points;  ///< from start to end
};

/// Reads measured loops: columns `displacement_um` and `force_N`, or in other units, written as for
/// read_height_errors(), and of several loops, one below the other, the column `at_column` that tells them apart. Other
/// columns are left alone.
/// @param at_column  "direction" ("+X" or degrees) or "cycle" (1, 2, ...)
/// @throws Error (input) that lists every faulty line, and every loop that does not turn round; Error (file) if the
///         file cannot be read
std::vector<MeasuredLoop> read_measured_loops(const std::string& path, const std::string& at_column);

}  // namespace bumpfoil
