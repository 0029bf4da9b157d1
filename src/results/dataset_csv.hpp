#pragma once

#include <cstddef>
#include <string>

#include "bumpfoil/results/dataset.hpp"

/// The first growing dimension of a dataset as a table: its coordinate, and the variables over it as columns of a CSV
/// file.
namespace bumpfoil {

/// Column names, with units.
std::string csv_header(const Dataset& dataset);

/// Appends one line for each entry in memory. @param first  number of the first   @return number of lines
std::size_t append_csv_rows(std::string& out, const Dataset& dataset, std::size_t first);

}  // namespace bumpfoil
