#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace bumpfoil {

/// How the cells of a CSV file are told apart: what programs write differs from country to country.
struct CsvDialect {
  char separator{','};
  std::string_view name{"commas"};  ///< of the separators, in messages

  /// The cells of a line, trimmed.
  [[nodiscard]] std::vector<std::string_view> cells(std::string_view line) const;

  /// A cell that is a finite number and nothing else, with a decimal comma where commas do not separate cells.
  [[nodiscard]] std::optional<double> number(std::string_view cell) const;
};

/// The separator of a header: the first of semicolon, tab and comma that is in it.
CsvDialect dialect_of(std::string_view header);

/// A unit at the end of a column's name: "_um".
struct ColumnUnit {
  std::string_view name;
  double size{};  ///< SI
};

inline constexpr std::array length_units{ColumnUnit{"m", 1.0}, ColumnUnit{"mm", 1e-3}, ColumnUnit{"um", 1e-6},
                                         ColumnUnit{"nm", 1e-9}};
inline constexpr std::array force_units{ColumnUnit{"N", 1.0}, ColumnUnit{"kN", 1e3}, ColumnUnit{"mN", 1e-3}};

/// The unit of a column whose name is `quantity` and one of these; absent where it is another column.
std::optional<ColumnUnit> unit_of_column(std::string_view column, std::string_view quantity,
                                         std::span<const ColumnUnit> units);

}  // namespace bumpfoil
