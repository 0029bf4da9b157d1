#include "io/height_errors_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "io/csv_lines.hpp"
#include "io/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view bump_column = "bump";
constexpr std::string_view name_advice = "name one height_error_um, or height_mm if it holds whole heights";

struct Separator {
  char character;
  std::string_view name;
};
constexpr std::array separators{Separator{';', "semicolons"}, Separator{'\t', "tabs"}, Separator{',', "commas"}};

struct Unit {
  std::string_view name;
  double size;  ///< m
};
constexpr std::array units{Unit{"m", 1.0}, Unit{"mm", 1e-3}, Unit{"um", 1e-6}, Unit{"nm", 1e-9}};

/// What a column of heights holds.
struct HeightColumn {
  std::size_t index{};
  Unit unit{};
  bool absolute{};  ///< heights over the sleeve, not errors
};

std::optional<HeightColumn> height_column(std::string_view name, std::size_t index) {
  for (const auto& [prefix, absolute] : {std::pair{"height_error_", false}, std::pair{"height_", true}}) {
    if (!name.starts_with(prefix)) continue;
    const std::string_view unit = name.substr(std::string_view(prefix).size());
    const auto found = std::find_if(units.begin(), units.end(), [&](const Unit& one) { return one.name == unit; });
    if (found != units.end()) return HeightColumn{index, *found, absolute};
  }
  return std::nullopt;
}

/// Takes the lines one by one.
class HeightErrorsReader {
 public:
  HeightErrorsReader(const std::string& path, int bumps, double height)
      : path_(path), height_(height), errors_(static_cast<std::size_t>(bumps)), lines_(errors_.size(), 0) {}

  void read_line(std::size_t line, std::string_view text) {
    if (text.empty() || text.starts_with('#')) return;
    if (!has_header_) return read_header(line, text);
    if (!column_) return;  // without it nothing is known of the rest
    const std::vector<std::string_view> cells = cells_of(text);
    if (cells.size() != columns_) {
      return fault(
          line, text,
          fmt::format("has {} columns, separated by {}, and the header {}", cells.size(), separator_.name, columns_),
          "write a value for every column");
    }
    const std::optional<std::size_t> index = bump_of(line, text, cells);
    if (!index) return;
    const std::optional<double> value = number(cells[column_->index]);
    if (!value) {
      return fault(line, text,
                   fmt::format("has no finite number for the height (columns are separated by {})", separator_.name),
                   fmt::format("give it in {}, without a unit", column_->unit.name));
    }
    lines_[*index] = line;
    errors_[*index] = *value * column_->unit.size - (column_->absolute ? height_ : 0.0);
    if (height_ > 0.0 && std::abs(errors_[*index]) >= height_ && implausible_++ == 0) {
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
      first_implausible_.what =
          fmt::format("{} further from the nominal height than a bump is high, {:.6g} m",
                      implausible_ == 1 ? "lies" : fmt::format("and {} more lie", implausible_ - 1), height_);
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

  [[nodiscard]] std::vector<std::string_view> cells_of(std::string_view text) const {
    std::vector<std::string_view> cells;
    for (;;) {
      const std::size_t end = text.find(separator_.character);
      cells.push_back(trimmed(text.substr(0, end)));
      if (end == std::string_view::npos) return cells;
      text.remove_prefix(end + 1);
    }
  }

  void read_header(std::size_t line, std::string_view text) {
    has_header_ = true;
    separator_ = *std::find_if(separators.begin(), separators.end() - 1,
                               [text](const Separator& one) { return text.find(one.character) != text.npos; });
    const std::vector<std::string_view> names = cells_of(text);
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
                      found == 0 ? "no column" : fmt::format("{} columns", found), columns_, separator_.name),
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

  [[nodiscard]] std::optional<double> number(std::string_view cell) const {
    std::string text(cell);
    if (separator_.character != ',') std::replace(text.begin(), text.end(), ',', '.');
    const auto value = parse<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
  }

  std::string path_;
  double height_;
  std::vector<double> errors_;
  std::vector<std::size_t> lines_;  ///< where each bump was given; 0 if it was not
  std::vector<Fault> faults_;
  bool has_header_{};
  Separator separator_{};
  std::size_t columns_{};
  std::optional<std::size_t> bump_index_;
  std::optional<HeightColumn> column_;
  std::size_t next_{};  ///< bump of the next line where these have no numbers
  int implausible_{};
  Fault first_implausible_;
};

}  // namespace

std::vector<double> read_height_errors(const std::string& path, int bumps, double height) {
  const std::string text = read_text_file(path);
  HeightErrorsReader reader(path, bumps, height);
  for_each_line(text, [&reader](std::size_t line, std::string_view content) { reader.read_line(line, content); });
  return reader.finish();
}

}  // namespace bumpfoil
