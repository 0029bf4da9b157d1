#pragma once

#include <string>

#include "bumpfoil/experiments/fit/fit.hpp"

namespace bumpfoil {

/// Reads a table of what was measured, a row for each place: the columns that data of this experiment have, of what is
/// measured those with a standard deviation. They go by the names of FitColumn and a unit ("h_min_um",
/// "Torque (N mm)"), or by those that `columns` of the data gives. Other columns are left alone.
/// @throws Error (input) that lists every faulty line, as read_measured_loops() does; Error (file)
void read_measured_table(const std::string& path, FitData& data);

}  // namespace bumpfoil
