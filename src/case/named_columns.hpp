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

/// A column of a measured CSV file, to be found by name.
struct WantedColumn {
  std::string_view key;                   ///< under which another name may be given
  std::optional<Dimension> dimension{};   ///< absent for plain numbers
  std::string_view unit{};                ///< in advice
  std::vector<std::string_view> names{};  ///< usual names on rigs and testing machines, by preference
  bool optional{};                        ///< files may lack it
};

struct NamedColumn {
  std::size_t index{};
  ColumnUnit unit{};
};

/// Finds a column by one of its usual names, or by a given one, which may be followed by a unit that the file lacks:
/// "Channel 3 [mm]". A missing or ambiguous column is an error of the header.
/// @param given   empty: by usual names
/// @param option  that gives names: "--columns", or "columns" of a case
std::optional<NamedColumn> find_named_column(CsvRows& rows, std::size_t line, std::string_view header,
                                             const std::vector<std::string>& columns, const WantedColumn& wanted,
                                             const std::string& given, std::string_view option);

/// "has no force among its 3 columns, separated by commas: ...".
std::string missing_column(const CsvRows& rows, std::string_view what, const std::vector<std::string>& columns);

/// Reads `displacement=NAME,force=NAME`: names with or without quotes, may contain commas.
/// @param keys     known keys, and the destination of their names
/// @param example  correct form for messages
/// @throws Error (input) if it does not start with a key
void parse_column_names(std::string_view text, std::span<const std::pair<std::string_view, std::string*>> keys,
                        std::string_view option, std::string_view example);

}  // namespace bumpfoil
