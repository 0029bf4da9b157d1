#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "bumpfoil/results/table.hpp"

/// Tables on the terminal: labels and units of the columns, five digits of a number, a word, or a dash where a number
/// is absent. A unit is left out where no number is known.
namespace bumpfoil {

/// One line per row, under the labels. A first column of texts is aligned to the left.
std::string table_lines(const Table& table);

/// One line per column, with its label before the rows, which are side by side, some at a time. A first column of texts
/// is the heading of each part. "torque: of asperities" becomes "  of asperities" under "torque".
std::string table_blocks(const Table& table);

/// "speeds 41 to 60 are in the files only"; nothing if all are shown.
std::string left_out(std::string_view things, std::size_t shown, std::size_t all);

}  // namespace bumpfoil
