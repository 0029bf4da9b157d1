#include "case/named_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bumpfoil/core/error.hpp"
#include "case/csv_lines.hpp"

namespace bumpfoil {
namespace {

/// Maximum number of columns listed in messages.
constexpr std::size_t most_named = 12;

std::optional<ColumnUnit> unit_in(std::string_view column, std::string_view name,
                                  const std::optional<Dimension>& dimension) {
  if (dimension) return unit_of_column(column, name, *dimension);
  return is_column(column, name) ? std::optional(ColumnUnit{"", 1.0}) : std::nullopt;
}

/// Candidate columns: those with the first known name that occurs.
std::vector<NamedColumn> by_known_names(const std::vector<std::string>& columns, const WantedColumn& wanted) {
  std::vector<NamedColumn> found;
  for (const std::string_view name : wanted.names) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (auto unit = unit_in(columns[i], name, wanted.dimension)) found.push_back({i, std::move(*unit)});
    }
    if (!found.empty()) break;
  }
  return found;
}

/// Columns with a given name, with the unit of the file or one given after the name.
std::vector<NamedColumn> by_given_name(const std::vector<std::string>& columns, const std::string& given,
                                       const std::optional<Dimension>& dimension) {
  const std::string name = given.substr(0, given.find_last_of("([_ \t"));
  const std::optional<ColumnUnit> unit = dimension ? unit_in(given, name, dimension) : std::nullopt;
  std::vector<NamedColumn> found;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool same = is_column(columns[i], given) || is_column(columns[i], name);
    if (auto of_file = unit_in(columns[i], given, dimension)) {
      found.push_back({i, std::move(*of_file)});
    } else if (unit && same) {
      found.push_back({i, *unit});
    }
  }
  return found;
}

/// Whether a column has a known name, but no unit or one of another dimension.
bool lacks_unit(const std::string& column, const WantedColumn& wanted) {
  if (!wanted.dimension) return false;
  return std::any_of(wanted.names.begin(), wanted.names.end(), [&column](std::string_view name) {
    if (is_column(column, name)) return true;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(Dimension::damping); ++i) {
      if (unit_of_column(column, name, static_cast<Dimension>(i))) return true;
    }
    return false;
  });
}

}  // namespace

std::string missing_column(const CsvRows& rows, std::string_view what, const std::vector<std::string>& columns) {
  const std::size_t named = std::min(columns.size(), most_named);
  return fmt::format("has no {} among its {} columns, separated by {}: \"{}\"{}", what, columns.size(),
                     rows.dialect().name,
                     fmt::join(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(named), "\", \""),
                     named < columns.size() ? ", ..." : "");
}

std::optional<NamedColumn> find_named_column(CsvRows& rows, std::size_t line, std::string_view header,
                                             const std::vector<std::string>& columns, const WantedColumn& wanted,
                                             const std::string& given, std::string_view option) {
  std::vector<NamedColumn> found =
      given.empty() ? by_known_names(columns, wanted) : by_given_name(columns, given, wanted.dimension);
  if (found.size() == 1) return std::move(found.front());
  const std::string unit = wanted.dimension ? fmt::format(" [{}]", wanted.unit) : "";
  const std::string assigned = fmt::format("{}=NAME{}", wanted.key, unit);
  const std::string choice = option.starts_with("--") ? fmt::format("{} '{}'", option, assigned)
                                                      : fmt::format("{} = \"{}\"", option, assigned);
  if (!found.empty()) {
    rows.error(line, header, fmt::format("has {} columns of the {}", found.size(), wanted.key),
               fmt::format("specify which one: {}", choice));
    return std::nullopt;
  }
  if (!given.empty()) {
    rows.error(line, header, missing_column(rows, given, columns),
               fmt::format("give one of these names, followed by its unit if the file has none: {}", choice));
    return std::nullopt;
  }
  if (wanted.optional && std::none_of(columns.begin(), columns.end(),
                                      [&wanted](const std::string& column) { return lacks_unit(column, wanted); })) {
    return std::nullopt;
  }
  std::vector<std::string> understood;
  for (const std::string_view name : wanted.names) {
    understood.push_back(wanted.dimension ? fmt::format("{}_{}", name, wanted.unit) : std::string(name));
  }
  const std::string otherwise = fmt::format("name a column {}", understood.front());
  rows.error(
      line, header, missing_column(rows, understood.front(), columns),
      fmt::format("{}; recognised names, followed by any unit: {}; for another name use {}",
                  wanted.dimension ? column_advice(columns, understood, *wanted.dimension, otherwise) : otherwise,
                  fmt::join(wanted.names, ", "), choice));
  return std::nullopt;
}

void parse_column_names(std::string_view text, std::span<const std::pair<std::string_view, std::string*>> keys,
                        std::string_view option, std::string_view example) {
  std::string* value = nullptr;
  while (!text.empty()) {
    const std::string_view part = trimmed(text.substr(0, text.find(',')));
    const auto key = std::find_if(keys.begin(), keys.end(), [part](const auto& one) {
      return part.starts_with(one.first) && part.substr(one.first.size()).starts_with('=');
    });
    if (key != keys.end()) {
      value = key->second;
      *value = part.substr(key->first.size() + 1);
    } else if (value) {
      *value += fmt::format(",{}", part);  // a column name with a comma
    } else {
      throw Error(ErrorKind::input,
                  {{"", 0, std::string(option), std::string(text), "does not start with the kind of column",
                    fmt::format("write {}, or some of these", example)}});
    }
    text.remove_prefix(std::min(text.size(), text.find(',')));
    if (!text.empty()) text.remove_prefix(1);
  }
  for (const auto& [key, name] : keys) std::erase(*name, '"');
}

}  // namespace bumpfoil
