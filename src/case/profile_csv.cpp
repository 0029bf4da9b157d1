#include "case/profile_csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "case/csv_dialect.hpp"
#include "case/csv_lines.hpp"
#include "case/csv_rows.hpp"
#include "case/text_file.hpp"

namespace bumpfoil {
namespace {

/// Accepted deviation of angles, relative to a step: instruments round them.
constexpr double angle_round_off = 0.05;

/// Takes the lines one by one.
class ProfileReader {
 public:
  explicit ProfileReader(const std::string& path) : rows_(path) {}

  void read_line(std::size_t line, std::string_view text) {
    if (is_csv_remark(text)) return;
    if (!rows_.has_header()) return read_header(line, text);
    if (!deviation_) return;  // without the column, the rest cannot be read
    const std::vector<std::string> cells = rows_.read(line, text);
    if (cells.empty()) return;
    const auto no_number = [&](const char* quantity) {
      rows_.error(
          line, text, numbers_.what(quantity, rows_.dialect()),
          fmt::format("give deviations in {} and angles in degrees, without units, with one decimal sign", unit_.name));
    };
    const std::optional<double> deviation = numbers_.read(cells[*deviation_]);
    if (!deviation) return no_number("deviation");
    const std::optional<double> angle = angle_ ? numbers_.read(cells[*angle_]) : 0.0;
    if (!angle) return no_number("angle");
    deviations_.push_back(*deviation * unit_.size);
    angles_.push_back({*angle, line, std::string(text)});
  }

  /// @throws Error (input) if there are errors.
  std::vector<double> finish() {
    if (!rows_.has_errors() && deviations_.empty()) {
      rows_.error("contains no deviations", "write angle_deg,deviation_um and a line for each of equal angles");
    }
    if (!rows_.has_errors() && angle_) check_angles();
    rows_.throw_if_wrong();
    return std::move(deviations_);
  }

 private:
  struct Angle {
    double degrees{};
    std::size_t line{};
    std::string text;
  };

  void read_header(std::size_t line, std::string_view text) {
    const std::vector<std::string> names = rows_.read_header(text);
    std::size_t found = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_column(names[i], "angle_deg")) angle_ = i;
      const std::optional<ColumnUnit> unit = unit_of_column(names[i], "deviation", Dimension::length);
      if (!unit) continue;
      deviation_ = i;
      unit_ = *unit;
      ++found;
    }
    if (found == 1) return;
    deviation_.reset();
    rows_.error(
        line, text,
        fmt::format("has {} of deviations among its {} columns, separated by {}",
                    found == 0 ? "no column" : fmt::format("{} columns", found), rows_.columns(), rows_.dialect().name),
        found == 0 ? column_advice(names, {"deviation_um"}, Dimension::length, "name one deviation_um") : "leave one");
  }

  void check_angles() {
    const double step = 360.0 / static_cast<double>(angles_.size());
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      const double due = static_cast<double>(i) * step;
      const Angle& angle = angles_[i];
      if (std::abs(angle.degrees - due) <= angle_round_off * step) continue;
      return rows_.error(
          angle.line, angle.text,
          fmt::format("should be {:.6g} degrees: {} lines are {:.6g} degrees apart", due, angles_.size(), step),
          "give equal angles starting at 0, without 360");
    }
  }

  std::vector<double> deviations_;
  std::vector<Angle> angles_;
  CsvRows rows_;
  CsvNumbers numbers_;
  std::optional<std::size_t> deviation_;
  std::optional<std::size_t> angle_;
  ColumnUnit unit_{};
};

}  // namespace

std::vector<double> read_profile(const std::string& path) {
  const std::string text = read_text_file(path);
  ProfileReader reader(path);
  for_each_line(text, [&reader](std::size_t line, std::string_view content) { reader.read_line(line, content); });
  return reader.finish();
}

}  // namespace bumpfoil
