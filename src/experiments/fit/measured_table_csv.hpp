#pragma once

#include <string>

#include "bumpfoil/experiments/fit/fit.hpp"

namespace bumpfoil {

/// Reads a table of measurements, one row per condition: the columns of this experiment's data, of measured ones those
/// with a standard deviation. Columns have the names of FitColumn and a unit ("h_min_um", "Torque (N mm)"), or those
/// given by `columns` of the data. Other columns are ignored.
/// @throws Error (input) that lists every wrong line, as read_measured_loops() does; Error (file)
void read_measured_table(const std::string& path, FitData& data);

}  // namespace bumpfoil
