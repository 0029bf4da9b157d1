#include "bumpfoil/results/csv_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace bumpfoil {
namespace {

void append_value(std::string& out, double value, const Form& form) {
  if (!std::isfinite(value)) return;
  if (form.kind == Form::truth) {
    out += value != 0.0 ? "true" : "false";
  } else if (form.kind == Form::flag) {
    out += form.words[static_cast<std::size_t>(value)];
  } else {
    fmt::format_to(std::back_inserter(out), "{:.17g}", value);
  }
}

/// Quoted where it has to be.
void append_text(std::string& out, const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char letter : text) out.append(letter == '"' ? 2 : 1, letter);
  out += '"';
}

}  // namespace

std::string csv_header(const Table& table) {
  std::string out;
  for (const TableColumn& column : table.columns) {
    if (!out.empty()) out += ',';
    out += column.meaning.key();
  }
  return out + '\n';
}

std::string csv_rows(const Table& table) {
  std::string out;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    char separator = '\0';
    for (const TableColumn& column : table.columns) {
      if (separator != '\0') out += separator;
      separator = ',';
      if (column.texts.empty()) {
        append_value(out, column.values[row], column.meaning.form);
      } else {
        append_text(out, column.texts[row]);
      }
    }
    out += '\n';
  }
  return out;
}

std::string csv_text(const Table& table) {
  return csv_header(table) + csv_rows(table);
}

}  // namespace bumpfoil
