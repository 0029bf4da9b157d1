#include "io/csv_dialect.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/csv_lines.hpp"

namespace bumpfoil {
namespace {

constexpr std::array dialects{CsvDialect{';', "semicolons"}, CsvDialect{'\t', "tabs"}, CsvDialect{',', "commas"}};

}  // namespace

std::vector<std::string_view> CsvDialect::cells(std::string_view line) const {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

std::optional<double> CsvDialect::number(std::string_view cell) const {
  std::string text(cell);
  if (separator != ',') std::replace(text.begin(), text.end(), ',', '.');
  const auto value = parse<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

CsvDialect dialect_of(std::string_view header) {
  return *std::find_if(dialects.begin(), dialects.end() - 1,
                       [header](const CsvDialect& one) { return header.find(one.separator) != header.npos; });
}

std::optional<ColumnUnit> unit_of_column(std::string_view column, std::string_view quantity,
                                         std::span<const ColumnUnit> units) {
  if (!column.starts_with(quantity) || column.substr(quantity.size()).substr(0, 1) != "_") return std::nullopt;
  const std::string_view unit = column.substr(quantity.size() + 1);
  const auto found = std::find_if(units.begin(), units.end(), [&](const ColumnUnit& one) { return one.name == unit; });
  return found == units.end() ? std::nullopt : std::optional(*found);
}

}  // namespace bumpfoil
