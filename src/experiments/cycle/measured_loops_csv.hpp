#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/measured_loop.hpp"

namespace bumpfoil {

/// The last measured cycle of a direction, or of a cycle number of a strip.
struct MeasuredLoop {
  std::optional<double> at{};  ///< direction in degrees, or cycle number of a strip; absent if the file has none
  LastCycle cycle;
};

/// Names of the columns; empty if the usual names apply.
struct MeasuredColumns {
  std::string displacement;  ///< "s [mm]"
  std::string force;
  std::string at;                        ///< direction or cycle
  std::string_view option{"--columns"};  ///< option that gives them
};

/// Reads `displacement=NAME,force=NAME,direction=NAME`, names with or without quotes, may contain commas.
/// @param option  of the command line, or key of the case, that gives them
/// @throws Error (input)
MeasuredColumns parse_measured_columns(std::string_view text, std::string_view option = "--columns");

/// Reads measured loops: a displacement and a force column, with common names ("displacement_um", "Load (N)", "Kraft
/// [kN]") or given ones, in the format of read_height_errors(); for several loops also the column `at_column` that
/// identifies them. Other columns are ignored. A given name may be followed by a unit that the file lacks: "Channel 3
/// [mm]".
/// @param at_column  "direction" ("+X" or degrees) or "cycle" (1, 2, ...)
/// @param at         value for a file without this column; empty if unknown
/// @throws Error (input) that lists every wrong line, and every loop that does not reverse; Error (file) if the
///         file cannot be read
std::vector<MeasuredLoop> read_measured_loops(const std::string& path, const std::string& at_column,
                                              const MeasuredColumns& columns = {}, const std::string& at = "");

}  // namespace bumpfoil
