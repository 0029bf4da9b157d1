#pragma once

#include <cstddef>
#include <string>

#include "bumpfoil/results/dataset.hpp"

/// The first dimension of a dataset that grows as a table: its coordinate, and the variables over it that are columns
/// of CSV files.
namespace bumpfoil {

/// Names of the columns, with the units in them.
std::string csv_header(const Dataset& dataset);

/// Appends a line for each entry in memory. @param first  number of the first   @return how many there are
std::size_t append_csv_rows(std::string& out, const Dataset& dataset, std::size_t first);

}  // namespace bumpfoil
