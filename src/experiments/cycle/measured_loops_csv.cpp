#include "experiments/cycle/measured_loops_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/validation.hpp"
#include "case/csv_dialect.hpp"
#include "case/csv_lines.hpp"
#include "case/csv_rows.hpp"
#include "case/named_columns.hpp"
#include "case/text_file.hpp"

namespace bumpfoil {
namespace {

constexpr std::array named_axes{std::pair{"+X", 0.0}, std::pair{"+Y", 90.0}, std::pair{"-X", 180.0},
                                std::pair{"-Y", 270.0}};

const WantedColumn wanted_displacement{
    "displacement",
    Dimension::length,
    "um",
    {"displacement", "disp", "deflection", "travel", "stroke", "position", "Weg", "Auslenkung", "Verschiebung"}};
const WantedColumn wanted_force{
    "force", Dimension::force, "N", {"force", "load", "load cell", "F", "Kraft", "Last", "force_direct"}};

/// Takes the lines one by one.
class LoopsReader {
 public:
  LoopsReader(const std::string& path, std::string at_column, MeasuredColumns columns, const std::string& at)
      : rows_(path), at_column_(std::move(at_column)), given_(std::move(columns)) {
    if (at.empty()) return;
    given_at_ = place(at);
    numbers_ = {};  // each file may have its own decimal sign
    if (!given_at_)
      rows_.error(fmt::format("is assigned to the {} {}, which does not exist", at_column_, at), at_advice());
  }

  void read_line(std::size_t line, std::string_view text) {
    if (is_csv_remark(text)) return;
    if (!rows_.has_header()) return read_header(line, text);
    if (!displacement_ || !force_) return;  // without these columns, the rest cannot be read
    const std::vector<std::string> cells = rows_.read(line, text);
    if (cells.empty()) return;
    const auto no_number = [&](const char* quantity) {
      rows_.error(line, text, numbers_.what(quantity, rows_.dialect()),
                  "give all without a unit, with one decimal sign");
    };
    const std::optional<double> displacement = numbers_.read(cells[displacement_->index]);
    if (!displacement) return no_number("displacement");
    const std::optional<double> force = numbers_.read(cells[force_->index]);
    if (!force) return no_number("force");
    std::optional<double> at = given_at_;
    if (at_) {
      at = place(cells[*at_]);
      if (!at) return rows_.error(line, text, fmt::format("has no {}", at_column_), at_advice());
    }
    points_at(at).push_back({*displacement * displacement_->unit.size, *force * force_->unit.size});
  }

  /// @throws Error (input) if there are errors
  std::vector<MeasuredLoop> finish() {
    if (points_.empty() && !rows_.has_errors()) {
      rows_.error("contains no loop", "write displacement_um,force_N and a line for each point of the loop");
    }
    std::vector<MeasuredLoop> loops;
    const bool wrong = rows_.has_errors();
    for (const auto& [at, points] : points_) {
      if (wrong) break;
      if (auto cycle = last_cycle(points)) {
        loops.push_back({at, std::move(*cycle)});
      } else {
        rows_.error(fmt::format("{} {} does not go to a displacement and back", at ? at_column_ : "the loop",
                                at ? fmt::format("{}", *at) : "in it"),
                    "give its points in the order of measurement, displacements positive towards the foils");
      }
    }
    rows_.throw_if_wrong();
    return loops;
  }

 private:
  void read_header(std::size_t line, std::string_view text) {
    const std::vector<std::string> names = rows_.read_header(text);
    displacement_ =
        find_named_column(rows_, line, text, names, wanted_displacement, given_.displacement, given_.option);
    force_ = find_named_column(rows_, line, text, names, wanted_force, given_.force, given_.option);
    const std::string& at_name = given_.at.empty() ? at_column_ : given_.at;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (is_column(names[i], at_name) || is_column(names[i], at_name + "_deg")) at_ = i;
    }
    if (!at_ && !given_.at.empty())
      rows_.error(line, text, missing_column(rows_, given_.at, names),
                  fmt::format("name one of these in {}", given_.option));
    if (at_ && given_at_) {
      rows_.error(line, text, fmt::format("has a column {}", names[*at_]),
                  fmt::format("leave out the {} after the file name", at_column_));
    }
  }

  [[nodiscard]] std::string at_advice() const {
    return at_column_ == "cycle" ? "write 1, 2, ..." : "write +X, -X, +Y, -Y or an angle in degrees";
  }

  std::optional<double> place(std::string_view cell) {
    const auto axis =
        std::find_if(named_axes.begin(), named_axes.end(), [cell](const auto& one) { return one.first == cell; });
    if (at_column_ != "cycle" && axis != named_axes.end()) return axis->second;
    return numbers_.read(cell);
  }

  std::vector<LoadingCurve::Point>& points_at(const std::optional<double>& at) {
    const auto found =
        std::find_if(points_.begin(), points_.end(), [&at](const auto& some) { return some.first == at; });
    if (found != points_.end()) return found->second;
    return points_.emplace_back(at, std::vector<LoadingCurve::Point>{}).second;
  }

  CsvRows rows_;
  std::string at_column_;
  MeasuredColumns given_;
  std::vector<std::pair<std::optional<double>, std::vector<LoadingCurve::Point>>> points_;
  CsvNumbers numbers_;
  std::optional<double> given_at_;
  std::optional<std::size_t> at_;
  std::optional<NamedColumn> displacement_;
  std::optional<NamedColumn> force_;
};

}  // namespace

MeasuredColumns parse_measured_columns(std::string_view text, std::string_view option) {
  MeasuredColumns columns;
  columns.option = option;
  const std::array<std::pair<std::string_view, std::string*>, 4> keys{{{"displacement", &columns.displacement},
                                                                       {"force", &columns.force},
                                                                       {"direction", &columns.at},
                                                                       {"cycle", &columns.at}}};
  parse_column_names(text, keys, option, "displacement=NAME,force=NAME,direction=NAME");
  return columns;
}

std::vector<MeasuredLoop> read_measured_loops(const std::string& path, const std::string& at_column,
                                              const MeasuredColumns& columns, const std::string& at) {
  const std::string text = read_text_file(path);
  LoopsReader reader(path, at_column, columns, at);
  for_each_line(text, [&reader](std::size_t line, std::string_view content) { reader.read_line(line, content); });
  return reader.finish();
}

}  // namespace bumpfoil
