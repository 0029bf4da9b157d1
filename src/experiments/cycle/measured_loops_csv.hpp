#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/measured_loop.hpp"

namespace bumpfoil {

/// The last cycle that was measured of a direction, or of a strip's cycle.
struct MeasuredLoop {
  std::optional<double> at{};  ///< direction in degrees, or number of a strip's cycle; absent where the file has none
  LastCycle cycle;
};

/// Which columns are which, by their names; empty where these are understood.
struct MeasuredColumns {
  std::string displacement;  ///< "s [mm]"
  std::string force;
  std::string at;                        ///< direction or cycle
  std::string_view option{"--columns"};  ///< by which they are given
};

/// Reads `displacement=NAME,force=NAME,direction=NAME`, names with or without quotes, commas in them included.
/// @param option  of the command line, or key of the case, that they are given by
/// @throws Error (input)
MeasuredColumns parse_measured_columns(std::string_view text, std::string_view option = "--columns");

/// Reads measured loops: a column of displacements and one of forces, by common names ("displacement_um", "Load (N)",
/// "Kraft [kN]") or by those given, written as for read_height_errors(); of several loops also the column `at_column`
/// that tells them apart. Other columns are left alone. A name that is given may have a unit behind it that the file
/// has not: "Channel 3 [mm]".
/// @param at_column  "direction" ("+X" or degrees) or "cycle" (1, 2, ...)
/// @param at         of a file that has no such column, where its loop belongs; empty where it is not said
/// @throws Error (input) that lists every faulty line, and every loop that does not turn round; Error (file) if the
///         file cannot be read
std::vector<MeasuredLoop> read_measured_loops(const std::string& path, const std::string& at_column,
                                              const MeasuredColumns& columns = {}, const std::string& at = "");

}  // namespace bumpfoil
