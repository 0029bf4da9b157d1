#pragma once

#include <string>

#include "bumpfoil/results/table.hpp"

/// Tables as CSV files: all digits of a number, true or false, or a word; nothing where a number is absent.
namespace bumpfoil {

/// Keys of the columns.
std::string csv_header(const Table& table);

/// One line per row.
std::string csv_rows(const Table& table);

/// Both.
std::string csv_text(const Table& table);

}  // namespace bumpfoil
