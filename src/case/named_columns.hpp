#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case/csv_dialect.hpp"
#include "case/csv_rows.hpp"
#include "case/units.hpp"

namespace bumpfoil {

/// A column of a rig's CSV file that is looked for by name.
struct WantedColumn {
  std::string_view key;                   ///< by which another name for it is given
  std::optional<Dimension> dimension{};   ///< absent of plain numbers
  std::string_view unit{};                ///< in advice
  std::vector<std::string_view> names{};  ///< that rigs and testing machines give it, the first preferred
  bool optional{};                        ///< files may be without
};

struct NamedColumn {
  std::size_t index{};
  ColumnUnit unit{};
};

/// Finds a column by one of its usual names, or by the one that is given, which may have a unit behind it that the file
/// has not: "Channel 3 [mm]". One that is missing, or is there more than once, is a fault of the header.
/// @param given   empty: by its usual names
/// @param option  by which names are given: "--columns", or "columns" of a case
std::optional<NamedColumn> find_named_column(CsvRows& rows, std::size_t line, std::string_view header,
                                             const std::vector<std::string>& columns, const WantedColumn& wanted,
                                             const std::string& given, std::string_view option);

/// "has no force among its 3 columns, separated by commas: ...".
std::string missing_column(const CsvRows& rows, std::string_view what, const std::vector<std::string>& columns);

/// Reads `displacement=NAME,force=NAME`: names with or without quotes, commas in them included.
/// @param keys     that there are, and where their names go
/// @param example  what to write
/// @throws Error (input) if it does not begin with a key
void parse_column_names(std::string_view text, std::span<const std::pair<std::string_view, std::string*>> keys,
                        std::string_view option, std::string_view example);

}  // namespace bumpfoil
