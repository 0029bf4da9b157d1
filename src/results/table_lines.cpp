#include "results/table_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t rows_per_block = 6;
constexpr std::size_t least_label_width = 12;
constexpr std::size_t least_block_width = 13;
constexpr std::size_t space_between = 2;

std::string cell_of(const TableColumn& column, std::size_t row) {
  if (!column.texts.empty()) return column.texts[row];
  const double value = column.values[row];
  if (!std::isfinite(value)) return "-";
  const Form& form = column.meaning.form;
  if (!form.words.empty()) return std::string(form.words[static_cast<std::size_t>(value)]);
  if (form.kind == Form::whole) return fmt::format("{}", value);
  return number_text(value, column.meaning.shown.size > 0.0 ? column.meaning.shown.size : 1.0);
}

/// A column as text.
struct ColumnText {
  std::string label{};
  std::string_view unit{};
  std::vector<std::string> cells{};
  std::size_t width{};  ///< of the longest cell or the unit
};

std::vector<ColumnText> texts_of(const Table& table) {
  std::vector<ColumnText> all;
  for (const TableColumn& column : table.columns) {
    ColumnText text{.label = column.meaning.label};
    for (std::size_t row = 0; row < table.rows(); ++row) text.cells.push_back(cell_of(column, row));
    text.unit = unit_beside(column.meaning.shown.name, text.cells);
    text.width = text.unit.size();
    for (const std::string& cell : text.cells) text.width = std::max(text.width, cell.size());
    all.push_back(std::move(text));
  }
  return all;
}

/// A label that continues that of a line above, "torque: of asperities" under "torque", is indented instead.
void indent_labels(std::vector<ColumnText>& columns) {
  std::string above;
  for (ColumnText& column : columns) {
    if (column.label.starts_with(above + ": ")) {
      column.label.replace(0, above.size() + 1, " ");
    } else {
      above = column.label;
    }
  }
}

/// Lines of words, each as wide as it may be or as its word.
std::vector<std::string> broken(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string word; in >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > width) {
      lines.push_back(word);
    } else {
      lines.back() += ' ' + word;
    }
  }
  return lines;
}

}  // namespace

std::string table_lines(const Table& table) {
  std::vector<ColumnText> columns = texts_of(table);
  std::vector<std::vector<std::string>> labels;
  std::size_t height = 0;
  for (ColumnText& column : columns) {
    labels.push_back(broken(column.label, std::max(column.width, least_label_width)));
    height = std::max(height, labels.back().size());
    for (const std::string& line : labels.back()) column.width = std::max(column.width, line.size());
  }
  std::string out;
  const bool named = !table.columns.empty() && !table.columns.front().texts.empty();
  const auto add_line = [&](const auto& cell) {
    std::string line;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::string text(cell(k));
      if (k > 0) line.append(space_between, ' ');
      line += k == 0 && named ? fmt::format("{:<{}}", text, columns[k].width)
                              : fmt::format("{:>{}}", text, columns[k].width);
    }
    out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  };
  for (std::size_t i = 0; i < height; ++i) {
    add_line([&](std::size_t k) {
      const std::size_t blank = height - labels[k].size();
      return i < blank ? std::string() : labels[k][i - blank];
    });
  }
  const bool units = std::any_of(columns.begin(), columns.end(), [](const auto& one) { return !one.unit.empty(); });
  if (units) add_line([&](std::size_t k) { return columns[k].unit; });
  for (std::size_t row = 0; row < table.rows(); ++row) add_line([&](std::size_t k) { return columns[k].cells[row]; });
  return out;
}

std::string table_blocks(const Table& table) {
  std::vector<ColumnText> columns = texts_of(table);
  indent_labels(columns);
  std::size_t label_width = 0;
  std::size_t unit_width = 0;
  std::size_t width = least_block_width;
  for (const ColumnText& column : columns) {
    label_width = std::max(label_width, column.label.size() + space_between);
    unit_width = std::max(unit_width, column.unit.size());
    width = std::max(width, column.width + 1);
  }
  const bool headed = !table.columns.empty() && !table.columns.front().texts.empty();
  std::string out;
  for (std::size_t first = 0; first < table.rows(); first += rows_per_block) {
    const std::size_t end = std::min(first + rows_per_block, table.rows());
    if (!out.empty()) out += '\n';
    for (std::size_t k = 0; k < columns.size(); ++k) {
      out += fmt::format("{:<{}}{:<{}}", columns[k].label, label_width, columns[k].unit, unit_width);
      for (std::size_t row = first; row < end; ++row) out += fmt::format("{:>{}}", columns[k].cells[row], width);
      out += '\n';
      if (k == 0 && headed) out += std::string(label_width + unit_width + width * (end - first), '-') + '\n';
    }
  }
  return out;
}

std::string left_out(std::string_view things, std::size_t shown, std::size_t all) {
  return shown < all ? fmt::format("{} {} to {} are in the files only\n", things, shown + 1, all) : std::string();
}

}  // namespace bumpfoil
