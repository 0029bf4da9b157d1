#include "case/height_errors_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "case/csv_dialect.hpp"
#include "case/csv_lines.hpp"
#include "case/csv_rows.hpp"
#include "case/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view bump_column = "bump";
constexpr std::string_view name_advice = "name one height_error_um, or height_mm if it holds whole heights";

/// Content of a column of heights.
struct HeightColumn {
  std::size_t index{};
  ColumnUnit unit{};
  bool absolute{};  ///< heights above the sleeve, not errors
};

std::optional<HeightColumn> height_column(std::string_view name, std::size_t index) {
  if (auto unit = unit_of_column(name, "height_error", Dimension::length)) {
    return HeightColumn{index, std::move(*unit), false};
  }
  if (auto unit = unit_of_column(name, "height", Dimension::length)) return HeightColumn{index, std::move(*unit), true};
  return std::nullopt;
}

/// Common units of heights, with their full names.
struct UsualUnit {
  std::string_view symbol, name;
  double size{};  ///< m
};

constexpr std::array usual_units{UsualUnit{"um", "micrometres", 1e-6}, UsualUnit{"mm", "millimetres", 1e-3},
                                 UsualUnit{"m", "metres", 1.0}, UsualUnit{"nm", "nanometres", 1e-9}};

/// Manufacturing errors are not all smaller, m: micrometres read as nanometres indicate a wrong unit.
constexpr double smallest_error = 1e-7;

/// "3, 7 to 12 and 14": bumps without a line.
std::string missing_bumps(const std::vector<std::size_t>& lines) {
  std::vector<std::string> runs;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] != 0) continue;
    const std::size_t first = i;
    while (i + 1 < lines.size() && lines[i + 1] == 0) ++i;
    runs.push_back(first == i ? fmt::format("{}", i + 1) : fmt::format("{} to {}", first + 1, i + 1));
  }
  constexpr std::size_t most_runs = 8;
  if (runs.size() > most_runs) {
    runs.resize(most_runs);
    runs.emplace_back("others");
  }
  std::string text = runs.front();
  for (std::size_t i = 1; i < runs.size(); ++i) text += (i + 1 < runs.size() ? ", " : " and ") + runs[i];
  return text;
}

/// Takes the lines one by one.
class HeightErrorsReader {
 public:
  HeightErrorsReader(const std::string& path, const std::vector<double>& heights, const std::vector<double>& rises)
      : rows_(path), heights_(heights), rises_(rises), given_(heights.size()), lines_(heights.size(), 0) {}

  void read_line(std::size_t line, std::string_view text) {
    if (is_csv_remark(text)) return;
    if (!rows_.has_header()) return read_header(line, text);
    if (!column_) return;  // without the column, the rest cannot be read
    const std::vector<std::string> cells = rows_.read(line, text);
    if (cells.empty()) return;
    const std::optional<std::size_t> index = bump_of(line, text, cells);
    if (!index) return;
    const std::optional<double> value = numbers_.read(cells[column_->index]);
    if (!value) {
      return rows_.error(line, text, numbers_.what("height", rows_.dialect()),
                         fmt::format("give all in {}, without a unit, with one decimal sign", column_->unit.name));
    }
    lines_[*index] = line;
    texts_.emplace(line, text);
    given_[*index] = *value;
  }

  /// @throws Error (input) if there are errors or a bump is missing.
  std::vector<double> finish() {
    if (!rows_.has_header()) {
      rows_.error("is empty",
                  fmt::format("write bump,height_error_um and one line for each of {} bumps", given_.size()));
    }
    // An unreadable line may be the missing one.
    const auto missing = std::count(lines_.begin(), lines_.end(), std::size_t{0});
    if (!rows_.has_errors() && missing > 0) {
      rows_.error(fmt::format("lacks bump{} {}", missing == 1 ? "" : "s", missing_bumps(lines_)),
                  fmt::format("give one line for each of {} bumps", lines_.size()));
    }
    std::vector<double> errors;
    if (column_) {
      errors = errors_in(column_->unit.size);
      check(errors);
    }
    rows_.throw_if_wrong();
    return errors;
  }

 private:
  void read_header(std::size_t line, std::string_view text) {
    const std::vector<std::string> names = rows_.read_header(text);
    std::size_t found = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_column(names[i], bump_column)) bump_index_ = i;
      std::optional<HeightColumn> column = height_column(names[i], i);
      if (!column) continue;
      column_ = std::move(column);
      ++found;
    }
    if (found == 1) return;
    column_.reset();
    rows_.error(
        line, text,
        fmt::format("has {} of heights among its {} columns, separated by {}",
                    found == 0 ? "no column" : fmt::format("{} columns", found), rows_.columns(), rows_.dialect().name),
        found == 0 ? column_advice(names, {"height_error_um", "height_um", "height_mm"}, Dimension::length,
                                   std::string(name_advice))
                   : "leave one");
  }

  /// Errors of the bumps if the column were in this unit; zero for bumps not given.
  [[nodiscard]] std::vector<double> errors_in(double unit) const {
    std::vector<double> errors(given_.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
      if (lines_[i] > 0) errors[i] = given_[i] * unit - (column_->absolute ? heights_[i] : 0.0);
    }
    return errors;
  }

  /// Whether the bump would be flat, or twice as high.
  [[nodiscard]] bool is_beyond(std::size_t bump, double error) const {
    return rises_[bump] > 0.0 && std::abs(error) >= rises_[bump];
  }

  [[nodiscard]] bool are_plausible(const std::vector<double>& errors) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      if (is_beyond(i, errors[i])) return false;
      largest = std::max(largest, std::abs(errors[i]));
    }
    // Absolute heights in a wrong unit are already beyond the bump.
    return column_->absolute || largest == 0.0 || largest >= smallest_error;
  }

  /// The common unit that makes the values plausible, if theirs does not.
  [[nodiscard]] std::string confusion() const {
    std::string own = column_->unit.name;
    for (const UsualUnit& unit : usual_units) {
      if (unit.symbol == column_->unit.name) own = unit.name;
    }
    for (const UsualUnit& unit : usual_units) {
      if (unit.name != own && are_plausible(errors_in(unit.size))) {
        return fmt::format("{} in a column of {}?", unit.name, own);
      }
    }
    return fmt::format("is the column in {}?", own);
  }

  /// Reports implausible values once, at the first line.
  void check(const std::vector<double>& errors) {
    if (are_plausible(errors)) return;
    std::vector<std::size_t> beyond;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      if (is_beyond(i, errors[i])) beyond.push_back(i);
    }
    const auto earlier = [this](std::size_t a, std::size_t b) { return lines_[a] < lines_[b]; };
    if (beyond.empty()) {
      const auto line = *std::find_if(lines_.begin(), lines_.end(), [](std::size_t one) { return one > 0; });
      return rows_.error(line, texts_.at(line), "and all others are less than 0.1 um from the nominal height",
                         confusion() + " Errors this small can be given in bump_foil.height_errors");
    }
    const std::size_t first = *std::min_element(beyond.begin(), beyond.end(), earlier);
    rows_.error(
        lines_[first], texts_.at(lines_[first]),
        fmt::format("{} further from the nominal height than a bump rises, {:.6g} m",
                    beyond.size() == 1 ? "lies" : fmt::format("and {} more lie", beyond.size() - 1), rises_[first]),
        2 * beyond.size() < errors.size() ? "correct it: most others are plausible" : confusion());
  }

  /// Bump index of the line, from 0.
  std::optional<std::size_t> bump_of(std::size_t line, std::string_view text, const std::vector<std::string>& cells) {
    if (!bump_index_) {
      if (next_ < given_.size()) return next_++;
      rows_.error(line, text, fmt::format("is one line more than the number of bumps, {}", given_.size()),
                  "remove it, or raise bump_foil.bumps");
      return std::nullopt;
    }
    const auto bump = parse<int>(cells[*bump_index_]);
    if (!bump || *bump < 1 || *bump > static_cast<int>(given_.size())) {
      rows_.error(line, text, "is not a bump number", fmt::format("count bumps from 1 to {}", given_.size()));
      return std::nullopt;
    }
    const auto index = static_cast<std::size_t>(*bump - 1);
    if (lines_[index] > 0) {
      rows_.error(line, text, fmt::format("repeats bump {}, given in line {}", *bump, lines_[index]),
                  "give every bump once");
      return std::nullopt;
    }
    return index;
  }

  CsvRows rows_;
  const std::vector<double>& heights_;        ///< m
  const std::vector<double>& rises_;          ///< m
  std::vector<double> given_;                 ///< of each bump, in the unit of the column
  std::vector<std::size_t> lines_;            ///< line of each bump; 0 if not given
  std::map<std::size_t, std::string> texts_;  ///< of these lines
  CsvNumbers numbers_;
  std::optional<std::size_t> bump_index_;
  std::optional<HeightColumn> column_;
  std::size_t next_{};  ///< bump of the next line in files without bump numbers
};

}  // namespace

std::vector<double> read_height_errors(const std::string& path, const std::vector<double>& heights,
                                       const std::vector<double>& rises) {
  const std::string text = read_text_file(path);
  HeightErrorsReader reader(path, heights, rises);
  for_each_line(text, [&reader](std::size_t line, std::string_view content) { reader.read_line(line, content); });
  return reader.finish();
}

}  // namespace bumpfoil
