#include "bumpfoil/sweep/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/core/status.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/number_text.hpp"
#include "results/table_lines.hpp"
#include "sweep/sweep_layout.hpp"

namespace bumpfoil {
namespace {

/// Maximum number of values listed.
constexpr std::size_t most_listed = 50;
/// Maximum number of parts of a result shown.
constexpr std::size_t most_shown_parts = 24;
constexpr std::size_t number_width = 12;

/// A quantity of the table.
struct SweptColumn {
  std::size_t number;  ///< index among the variables
  VariableMeaning meaning;
  bool known;  ///< at any point

  /// "maximum force (N)"
  [[nodiscard]] std::string heading() const {
    const std::string_view unit = known ? meaning.shown.name : "";
    return unit.empty() ? meaning.label : fmt::format("{} ({})", meaning.label, unit);
  }
};

std::vector<SweptColumn> columns_of(const Dataset& data, const std::vector<SweepPoint>& points) {
  std::vector<SweptColumn> columns;
  for (std::size_t i = 0; i < data.variables.size(); ++i) {
    const VariableMeaning& meaning = data.variables[i].meaning;
    if ((meaning.tags & tag::headline) == 0) continue;
    const bool known = std::any_of(points.begin(), points.end(), [i, &meaning](const SweepPoint& point) {
      const std::vector<double>& values = values_of(point, meaning.name, i);
      return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    });
    columns.push_back({i, meaning, known});
  }
  return columns;
}

/// One block of the table: a direction, a cycle of a strip, a vibration.
class Block {
 public:
  Block(const Sweep& sweep, const std::vector<SweepPoint>& points, const SweepLayout& layout, std::size_t place)
      : sweep_(sweep),
        points_(points),
        place_(place),
        names_(each(layout.dataset.variables, [](const Variable& one) { return one.meaning.name; })),
        columns_(columns_of(layout.dataset, points)) {
    const auto& variables = layout.dataset.variables;
    const auto status = std::find_if(variables.begin(), variables.end(),
                                     [](const Variable& one) { return one.meaning.name == "status"; });
    status_ = static_cast<std::size_t>(status - variables.begin());
    words_ = status->meaning.form.words;
  }

  /// Whether any point has started it.
  [[nodiscard]] bool begun() const {
    for (std::size_t point = 0; point < points_.size(); ++point) {
      const std::string_view word = status(point);
      if (word != "-" && word != name_of(Status::interrupted)) return true;
    }
    return false;
  }

  /// One line for each value of a single key.
  [[nodiscard]] std::string lines() const {
    const SweptKey& swept = sweep_.axes.front().swept;
    Table table;
    table.add(shown_column(swept.key), swept.values);
    std::vector<std::string> words;
    for (std::size_t point = 0; point < points_.size(); ++point) words.emplace_back(status(point));
    for (const SweptColumn& column : columns_) {
      std::vector<double> values;
      for (std::size_t point = 0; point < points_.size(); ++point) values.push_back(value(column.number, point));
      table.add(column.meaning, std::move(values));
    }
    table.add(shown_column("status"), std::move(words));
    return table_lines(table);
  }

  /// Two lines for each quantity.
  [[nodiscard]] std::string extremes() const {
    std::string out;
    for (const SweptColumn& column : columns_) {
      std::optional<std::size_t> smallest;
      std::optional<std::size_t> largest;
      for (std::size_t point = 0; point < points_.size(); ++point) {
        const double number = value(column.number, point);
        if (!std::isfinite(number)) continue;
        if (!smallest || number < value(column.number, *smallest)) smallest = point;
        if (!largest || number > value(column.number, *largest)) largest = point;
      }
      out += extreme_line(column.heading(), "smallest", column, smallest);
      out += extreme_line("", "largest", column, largest);
    }
    return out;
  }

 private:
  /// NaN if the point has fewer values.
  [[nodiscard]] double value(std::size_t variable, std::size_t point) const {
    const std::vector<double>& values = values_of(points_[point], names_[variable], variable);
    return place_ < values.size() ? values[place_] : absent;
  }

  [[nodiscard]] std::string_view status(std::size_t point) const {
    const double number = value(status_, point);
    return std::isfinite(number) ? words_[static_cast<std::size_t>(number)] : "-";
  }

  [[nodiscard]] std::string extreme_line(std::string_view heading, std::string_view which, const SweptColumn& column,
                                         std::optional<std::size_t> point) const {
    constexpr std::size_t heading_width = 30;
    return fmt::format("{:<{}}{:<9}{:>{}}  {}\n", heading, heading_width, which,
                       point ? number_text(value(column.number, *point), column.meaning.shown.size) : "-", number_width,
                       point ? "at " + point_name(sweep_, *point) : "");
  }

  const Sweep& sweep_;
  const std::vector<SweepPoint>& points_;
  std::size_t place_;
  std::vector<std::string> names_;  // of the variables
  std::vector<SweptColumn> columns_;
  std::size_t status_{};
  std::span<const std::string_view> words_;
};

/// Lines of every point, preceded by its name.
std::vector<std::string> named_lines(const Sweep& sweep, const std::vector<SweepPoint>& points,
                                     std::vector<std::string> SweepPoint::*lines) {
  std::vector<std::string> all;
  for (std::size_t point = 0; point < points.size(); ++point) {
    for (const std::string& line : points[point].*lines) {
      all.push_back(fmt::format("{}: {}", point_name(sweep, point), line));
    }
  }
  return all;
}

}  // namespace

std::string sweep_table(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const bool listed = sweep.axes.size() == 1 && points.size() <= most_listed;
  const SweepLayout layout = layout_of(sweep, points);
  std::string out;
  std::size_t shown = 0;
  for (const auto& [name, place] : layout.parts) {
    const Block block(sweep, points, layout, place);
    if (!block.begun()) continue;
    if (++shown > most_shown_parts) continue;
    out += fmt::format("{}{}\n{}", out.empty() ? "" : "\n", name, listed ? block.lines() : block.extremes());
  }
  if (shown > most_shown_parts) out += fmt::format("\n{} more are in the files only\n", shown - most_shown_parts);
  return out;
}

std::vector<std::string> failure_lines(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  return named_lines(sweep, points, &SweepPoint::failures);
}

std::vector<std::string> warning_lines(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  return named_lines(sweep, points, &SweepPoint::warnings);
}

}  // namespace bumpfoil
