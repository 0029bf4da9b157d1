#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/units.hpp"

namespace bumpfoil {

/// Dialect of a CSV file: separators and decimal signs differ from country to country.
struct CsvDialect {
  char separator{','};              ///< null where the header is a single column
  std::string_view name{"commas"};  ///< of the separators, in messages

  /// The cells of a line, trimmed, out of their quotes (RFC 4180), without a # and what follows it behind the last.
  /// @param columns their number; 0 for the header, which defines it
  [[nodiscard]] std::vector<std::string> cells(std::string_view line, std::size_t columns = 0) const;
};

/// The separator of a header: the first of semicolon, tab and comma that is in it outside quotes.
CsvDialect dialect_of(std::string_view header);

/// Whether a line holds no cells: a blank one, a comment, or "sep=;" of spreadsheets, which the header says as well.
bool is_csv_remark(std::string_view line);

/// Numbers of a file, with decimal points or with decimal commas, but not with both.
class CsvNumbers {
 public:
  /// A cell that is a finite number and nothing else.
  std::optional<double> read(std::string_view cell);

  /// The error of the last cell, if it was not a number.
  [[nodiscard]] std::string what(std::string_view quantity, const CsvDialect& dialect) const;

 private:
  char sign_{};  ///< that the file has before its decimals; null before the first
  bool mixed_{};
};

/// A unit at the end of a column's name: "_um", " (um)".
struct ColumnUnit {
  std::string name;
  double size{};  ///< SI
};

/// Whether a column has a name, case, spaces and brackets apart.
bool is_column(std::string_view column, std::string_view name);

/// The unit of a column whose name is `quantity` and a unit of this dimension, case, spaces and brackets apart; absent
/// where it is another column.
std::optional<ColumnUnit> unit_of_column(std::string_view column, std::string_view quantity, Dimension dimension);

/// Advice where none of the columns is one of the quantities: which is nearest, or lacks its unit.
/// @param wanted  names of columns with their units, "height_um"
std::string column_advice(const std::vector<std::string>& columns, const std::vector<std::string>& wanted,
                          Dimension dimension, std::string otherwise);

}  // namespace bumpfoil
