#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/units.hpp"

namespace bumpfoil {

/// Dialect of a CSV file: separators and decimal signs depend on the locale.
struct CsvDialect {
  char separator{','};              ///< null if the header is a single column
  std::string_view name{"commas"};  ///< name of the separator in messages

  /// The cells of a line, trimmed and unquoted (RFC 4180), without a trailing # comment.
  /// @param columns their number; 0 for the header, which defines it
  [[nodiscard]] std::vector<std::string> cells(std::string_view line, std::size_t columns = 0) const;
};

/// The separator of a header: the first of semicolon, tab and comma that it contains outside quotes.
CsvDialect dialect_of(std::string_view header);

/// Whether a line has no cells: blank, a comment, or the "sep=;" of spreadsheets, which the header already implies.
bool is_csv_remark(std::string_view line);

/// Parses numbers of a file, with either decimal points or decimal commas, but not both.
class CsvNumbers {
 public:
  /// The value of a cell that is entirely a finite number.
  std::optional<double> read(std::string_view cell);

  /// The error in the last cell, if it was not a number.
  [[nodiscard]] std::string what(std::string_view quantity, const CsvDialect& dialect) const;

 private:
  char sign_{};  ///< decimal sign of the file; null before the first
  bool mixed_{};
};

/// A unit at the end of a column's name: "_um", " (um)".
struct ColumnUnit {
  std::string name;
  double size{};  ///< SI
};

/// Whether a column has this name, ignoring case, spaces and brackets.
bool is_column(std::string_view column, std::string_view name);

/// The unit of a column whose name is `quantity` and a unit of this dimension, ignoring case, spaces and brackets;
/// absent for other columns.
std::optional<ColumnUnit> unit_of_column(std::string_view column, std::string_view quantity, Dimension dimension);

/// Advice if no column is one of the quantities: the most similar one, or one without its unit.
/// @param wanted  names of columns with their units, "height_um"
std::string column_advice(const std::vector<std::string>& columns, const std::vector<std::string>& wanted,
                          Dimension dimension, std::string otherwise);

}  // namespace bumpfoil
