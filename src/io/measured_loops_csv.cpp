#include "io/measured_loops_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "bumpfoil/analysis/measured_loop.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/validation.hpp"
#include "io/csv_dialect.hpp"
#include "io/csv_lines.hpp"
#include "io/csv_rows.hpp"
#include "io/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::array axes{std::pair{"+X", 0.0}, std::pair{"+Y", 90.0}, std::pair{"-X", 180.0}, std::pair{"-Y", 270.0}};

struct Column {
  std::size_t index{};
  ColumnUnit unit{};
};

/// Takes the lines one by one.
class LoopsReader {
 public:
  LoopsReader(const std::string& path, const std::string& at_column) : rows_(path), at_column_(at_column) {}

  void read_line(std::size_t line, std::string_view text) {
    if (is_csv_remark(text)) return;
    if (!rows_.has_header()) return read_header(line, text);
    if (!displacement_ || !force_) return;  // without them nothing is known of the rest
    const std::vector<std::string> cells = rows_.read(line, text);
    if (cells.empty()) return;
    const auto no_number = [&](const char* quantity) {
      rows_.fault(line, text, numbers_.what(quantity, rows_.dialect()),
                  "give all without a unit, with one decimal sign");
    };
    const std::optional<double> displacement = numbers_.read(cells[displacement_->index]);
    if (!displacement) return no_number("displacement");
    const std::optional<double> force = numbers_.read(cells[force_->index]);
    if (!force) return no_number("force");
    std::optional<double> at;
    if (at_) {
      at = place(cells[*at_]);
      if (!at) return rows_.fault(line, text, fmt::format("has no {}", at_column_), at_advice());
    }
    loop_at(at).points.push_back({*displacement * displacement_->unit.size, *force * force_->unit.size});
  }

  /// @throws Error (input) if there was a fault
  std::vector<MeasuredLoop> finish() {
    if (loops_.empty() && !rows_.faulty()) {
      rows_.fault("holds no loop", "write displacement_um,force_N and a line for each point of the loop");
    }
    for (const MeasuredLoop& loop : loops_) {
      if (rows_.faulty() || turns_round(loop.points)) continue;
      rows_.fault(fmt::format("{} {} does not go to a displacement and back", loop.at ? at_column_ : "the loop",
                              loop.at ? fmt::format("{}", *loop.at) : "in it"),
                  "give its points in the order of measurement, displacements positive towards the foils");
    }
    rows_.throw_if_faulty();
    return std::move(loops_);
  }

 private:
  void read_header(std::size_t line, std::string_view text) {
    const std::vector<std::string> names = rows_.read_header(text);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_column(names[i], at_column_) || is_column(names[i], at_column_ + "_deg")) at_ = i;
      if (auto unit = unit_of_column(names[i], "displacement", Dimension::length)) displacement_ = {i, *unit};
      if (auto unit = unit_of_column(names[i], "force", Dimension::force)) force_ = {i, *unit};
    }
    const auto miss = [&](const std::string& name, Dimension dimension) {
      rows_.fault(
          line, text,
          fmt::format("has no {} among its {} columns, separated by {}", name, rows_.columns(), rows_.dialect().name),
          column_advice(names, {name}, dimension, fmt::format("name a column {}, or with another unit", name)));
    };
    if (!displacement_) miss("displacement_um", Dimension::length);
    if (!force_) miss("force_N", Dimension::force);
  }

  [[nodiscard]] std::string at_advice() const {
    return at_column_ == "cycle" ? "write 1, 2, ..." : "write +X, -X, +Y, -Y or an angle in degrees";
  }

  std::optional<double> place(std::string_view cell) {
    const auto axis = std::find_if(axes.begin(), axes.end(), [cell](const auto& one) { return one.first == cell; });
    if (at_column_ != "cycle" && axis != axes.end()) return axis->second;
    return numbers_.read(cell);
  }

  MeasuredLoop& loop_at(const std::optional<double>& at) {
    const auto found =
        std::find_if(loops_.begin(), loops_.end(), [&at](const MeasuredLoop& loop) { return loop.at == at; });
    if (found != loops_.end()) return *found;
    loops_.push_back({at, {}});
    return loops_.back();
  }

  CsvRows rows_;
  std::string at_column_;
  std::vector<MeasuredLoop> loops_;
  CsvNumbers numbers_;
  std::optional<std::size_t> at_;
  std::optional<Column> displacement_;
  std::optional<Column> force_;
};

}  // namespace

std::vector<MeasuredLoop> read_measured_loops(const std::string& path, const std::string& at_column) {
  const std::string text = read_text_file(path);
  LoopsReader reader(path, at_column);
  for_each_line(text, [&reader](std::size_t line, std::string_view content) { reader.read_line(line, content); });
  return reader.finish();
}

}  // namespace bumpfoil
