#include "case/csv_dialect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "bumpfoil/core/nearest_name.hpp"
#include "case/csv_lines.hpp"

namespace bumpfoil {
namespace {

constexpr std::array dialects{CsvDialect{';', "semicolons"}, CsvDialect{'\t', "tabs"}, CsvDialect{',', "commas"}};
constexpr CsvDialect single_column{'\0', "nothing"};

constexpr std::string_view brackets_and_spaces = " \t_-./()[]{}";

std::string replaced(std::string_view text, std::string_view old, std::string_view by) {
  std::string out;
  for (std::size_t at = text.find(old); at != std::string_view::npos; at = text.find(old)) {
    out.append(text.substr(0, at)).append(by);
    text.remove_prefix(at + old.size());
  }
  return out.append(text);
}

/// Replaces micro by "u", whether encoded as sign or letter, in UTF-8 or Latin-1.
std::string without_micro(std::string_view column) {
  std::string text = replaced(replaced(column, "\xc2\xb5", "u"), "\xce\xbc", "u");
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool in_utf8 = i > 0 && static_cast<unsigned char>(text[i - 1]) >= 0x80;
    if (text[i] == '\xb5' && !in_utf8) text[i] = 'u';
  }
  return text;
}

/// Rest of a column name after the quantity; absent if it does not start with it.
std::optional<std::string> behind_quantity(std::string_view column, std::string_view quantity) {
  const std::string text = without_micro(column);
  const auto is_filling = [](char c) { return brackets_and_spaces.find(c) != std::string_view::npos; };
  std::size_t at = 0;
  for (const char c : without_micro(quantity)) {
    if (is_filling(c)) continue;
    while (at < text.size() && is_filling(text[at])) ++at;
    if (at == text.size() || lower(text[at]) != lower(c)) return std::nullopt;
    ++at;
  }
  if (at < text.size() && !is_filling(text[at])) return std::nullopt;  // a longer word
  const std::size_t begin = text.find_first_not_of(brackets_and_spaces, at);
  if (begin == std::string::npos) return std::string();
  return text.substr(begin, text.find_last_not_of(brackets_and_spaces) - begin + 1);
}

}  // namespace

std::vector<std::string> CsvDialect::cells(std::string_view line, std::size_t columns) const {
  std::vector<std::string> cells;
  std::string cell;
  bool quoted = false;  // inside quotes
  bool whole = false;   // the cell was quoted: kept untrimmed
  const auto end_cell = [&] {
    cells.emplace_back(whole ? cell : trimmed(cell));
    cell.clear();
    whole = false;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool again = i + 1 < line.size() && line[i + 1] == c;
    if (quoted && c == '"' && again) {
      cell += c;
      ++i;
    } else if (quoted) {
      quoted = c != '"';
      if (quoted) cell += c;
    } else if (c == '"' && trimmed(cell).empty()) {
      cell.clear();
      quoted = whole = true;
    } else if (c == separator && c != '\0') {
      end_cell();
    } else if (c == '#' && cells.size() + 1 >= columns && i > 0 && (line[i - 1] == ' ' || line[i - 1] == '\t')) {
      break;
    } else if (!whole || trimmed(line.substr(i, 1)).size() == 1) {
      cell += c;
    }
  }
  end_cell();
  return cells;
}

CsvDialect dialect_of(std::string_view header) {
  const std::string_view names = header.substr(0, header.find(" #"));
  for (const CsvDialect& dialect : dialects) {
    if (dialect.cells(names).size() > 1) return dialect;
  }
  return single_column;
}

bool is_csv_remark(std::string_view line) {
  return line.empty() || line.starts_with('#') || (line.size() <= 5 && lower(std::string(line)).starts_with("sep="));
}

std::optional<double> CsvNumbers::read(std::string_view cell) {
  std::string text = replaced(cell, "\xe2\x88\x92", "-");  // the typographic minus
  const std::size_t at = text.find_first_of(".,");
  const char sign = at == std::string::npos ? '\0' : text[at];
  if (sign == ',') text[at] = '.';
  const auto value = parse<double>(text);
  mixed_ = false;
  if (!value || !std::isfinite(*value)) return std::nullopt;
  mixed_ = sign != '\0' && sign_ != '\0' && sign != sign_;
  if (sign != '\0' && !mixed_) sign_ = sign;
  return mixed_ ? std::nullopt : value;
}

std::string CsvNumbers::what(std::string_view quantity, const CsvDialect& dialect) const {
  if (mixed_)
    return fmt::format("has a decimal {}", sign_ == '.' ? "comma where earlier lines have points"
                                                        : "point where earlier lines have commas");
  return fmt::format("has no finite number for the {} (columns are separated by {})", quantity, dialect.name);
}

bool is_column(std::string_view column, std::string_view name) {
  const auto rest = behind_quantity(column, name);
  return rest && rest->empty();
}

std::optional<ColumnUnit> unit_of_column(std::string_view column, std::string_view quantity, Dimension dimension) {
  const auto unit = behind_quantity(column, quantity);
  if (!unit || unit->empty()) return std::nullopt;
  // Some files use capitals, or "in mm"; results of this program use "N_m_per_rad".
  const std::string spelt = replaced(replaced(*unit, "_per_", "/"), "_", " ");
  for (const std::string& name :
       {*unit, lower(*unit), spelt, unit->starts_with("in ") ? unit->substr(3) : std::string()}) {
    const auto size = parse_quantity("1 " + name, dimension);
    if (const double* value = std::get_if<double>(&size)) return ColumnUnit{name, *value};
  }
  return std::nullopt;
}

std::string column_advice(const std::vector<std::string>& columns, const std::vector<std::string>& wanted,
                          Dimension dimension, std::string otherwise) {
  for (const std::string& column : columns) {
    for (const std::string& name : wanted) {
      const auto unit = behind_quantity(column, name.substr(0, name.rfind('_')));
      if (!unit) continue;
      return unit->empty() ? fmt::format("say its unit: {}", name)
                           : fmt::format("\"{}\" is not a unit for {}: write {}", *unit, name_of(dimension), name);
    }
  }
  for (const std::string& column : columns) {
    if (const auto nearest = nearest_name(column, wanted)) return fmt::format("did you mean \"{}\"?", *nearest);
  }
  return otherwise;
}

}  // namespace bumpfoil
