#include "io/height_errors_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "io/csv_dialect.hpp"
#include "io/csv_lines.hpp"
#include "io/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view bump_column = "bump";
constexpr std::string_view name_advice = "name one height_error_um, or height_mm if it holds whole heights";

/// What a column of heights holds.
struct HeightColumn {
  std::size_t index{};
  ColumnUnit unit{};
  bool absolute{};  ///< heights over the sleeve, not errors
};

std::optional<HeightColumn> height_column(std::string_view name, std::size_t index) {
  if (const auto unit = unit_of_column(name, "height_error", length_units)) return HeightColumn{index, *unit, false};
  if (const auto unit = unit_of_column(name, "height", length_units)) return HeightColumn{index, *unit, true};
  return std::nullopt;
}

/// Takes the lines one by one.
class HeightErrorsReader {
 public:
  HeightErrorsReader(const std::string& path, const std::vector<double>& heights)
      : path_(path), heights_(heights), errors_(heights.size()), lines_(heights.size(), 0) {}

  void read_line(std::size_t line, std::string_view text) {
    if (text.empty() || text.starts_with('#')) return;
    if (!has_header_) return read_header(line, text);
    if (!column_) return;  // without it nothing is known of the rest
    const std::vector<std::string_view> cells = dialect_.cells(text);
    if (cells.size() != columns_) {
      return fault(
          line, text,
          fmt::format("has {} columns, separated by {}, and the header {}", cells.size(), dialect_.name, columns_),
          "write a value for every column");
    }
    const std::optional<std::size_t> index = bump_of(line, text, cells);
    if (!index) return;
    const std::optional<double> value = dialect_.number(cells[column_->index]);
    if (!value) {
      return fault(line, text,
                   fmt::format("has no finite number for the height (columns are separated by {})", dialect_.name),
                   fmt::format("give it in {}, without a unit", column_->unit.name));
    }
    lines_[*index] = line;
    const double height = heights_[*index];
    errors_[*index] = *value * column_->unit.size - (column_->absolute ? height : 0.0);
    if (height > 0.0 && std::abs(errors_[*index]) >= height && implausible_++ == 0) {
      implausible_height_ = height;
      first_implausible_ = {path_, line, "line", std::string(text), "", ""};
    }
  }

  /// @throws Error (input) if there was a fault or a bump is missing.
  std::vector<double> finish() {
    if (!has_header_) {
      faults_.push_back({path_, 0, "", "", "is empty",
                         fmt::format("write bump,height_error_um and one line for each of {} bumps", errors_.size())});
    }
    const bool all_read = faults_.empty();  // a line that could not be read may be the one that is missing
    for (std::size_t i = 0; all_read && i < lines_.size(); ++i) {
      if (lines_[i] == 0) {
        faults_.push_back({path_, 0, "", "", fmt::format("lacks bump {}", i + 1),
                           fmt::format("give one line for each of {} bumps", lines_.size())});
      }
    }
    if (implausible_ > 0) {
      first_implausible_.what = fmt::format(
          "{} further from the nominal height than a bump is high, {:.6g} m",
          implausible_ == 1 ? "lies" : fmt::format("and {} more lie", implausible_ - 1), implausible_height_);
      first_implausible_.advice = column_->unit.size == 1.0 ? "micrometres in a column of metres?"
                                                            : fmt::format("is the column in {}?", column_->unit.name);
      faults_.push_back(first_implausible_);
    }
    if (!faults_.empty()) throw Error(ErrorKind::input, std::move(faults_));
    return std::move(errors_);
  }

 private:
  void fault(std::size_t line, std::string_view text, std::string what, std::string advice) {
    faults_.push_back({path_, line, "line", std::string(text), std::move(what), std::move(advice)});
  }

  void read_header(std::size_t line, std::string_view text) {
    has_header_ = true;
    dialect_ = dialect_of(text);
    const std::vector<std::string_view> names = dialect_.cells(text);
    columns_ = names.size();
    std::size_t found = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == bump_column) bump_index_ = i;
      const std::optional<HeightColumn> column = height_column(names[i], i);
      if (!column) continue;
      column_ = column;
      ++found;
    }
    if (found == 1) return;
    column_.reset();
    fault(line, text,
          fmt::format("has {} of heights among its {} columns, separated by {}",
                      found == 0 ? "no column" : fmt::format("{} columns", found), columns_, dialect_.name),
          found == 0 ? std::string(name_advice) : "leave one");
  }

  /// Whose line it is, from 0.
  std::optional<std::size_t> bump_of(std::size_t line, std::string_view text,
                                     const std::vector<std::string_view>& cells) {
    if (!bump_index_) {
      if (next_ < errors_.size()) return next_++;
      fault(line, text, fmt::format("is one line more than there are bumps, {}", errors_.size()),
            "remove it, or raise bump_foil.bumps");
      return std::nullopt;
    }
    const auto bump = parse<int>(cells[*bump_index_]);
    if (!bump || *bump < 1 || *bump > static_cast<int>(errors_.size())) {
      fault(line, text, "does not have the number of a bump", fmt::format("count bumps from 1 to {}", errors_.size()));
      return std::nullopt;
    }
    const auto index = static_cast<std::size_t>(*bump - 1);
    if (lines_[index] > 0) {
      fault(line, text, fmt::format("repeats bump {}, given in line {}", *bump, lines_[index]), "give every bump once");
      return std::nullopt;
    }
    return index;
  }

  std::string path_;
  const std::vector<double>& heights_;  ///< m
  std::vector<double> errors_;
  std::vector<std::size_t> lines_;  ///< where each bump was given; 0 if it was not
  std::vector<Fault> faults_;
  bool has_header_{};
  CsvDialect dialect_;
  std::size_t columns_{};
  std::optional<std::size_t> bump_index_;
  std::optional<HeightColumn> column_;
  std::size_t next_{};  ///< bump of the next line where these have no numbers
  int implausible_{};
  double implausible_height_{};  ///< of the first one
  Fault first_implausible_;
};

}  // namespace

std::vector<double> read_height_errors(const std::string& path, const std::vector<double>& heights) {
  const std::string text = read_text_file(path);
  HeightErrorsReader reader(path, heights);
  for_each_line(text, [&reader](std::size_t line, std::string_view content) { reader.read_line(line, content); });
  return reader.finish();
}

}  // namespace bumpfoil
