#include "bumpfoil/io/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "bumpfoil/io/failures.hpp"
#include "bumpfoil/io/warnings.hpp"
#include "io/number_text.hpp"
#include "io/sweep_values.hpp"

namespace bumpfoil {
namespace {

constexpr std::array<std::string_view, 4> headlines{"max_force", "loaded_stiffness", "loop_energy", "loss_factor"};
/// More values than this are not listed.
constexpr std::size_t most_rows = 50;
constexpr std::size_t number_width = 12;

/// "maximum force (N)"
std::string heading_of(const CycleQuantity& quantity) {
  return quantity.shown.name.empty() ? std::string(quantity.label)
                                     : fmt::format("{} ({})", quantity.label, quantity.shown.name);
}

std::vector<CycleQuantity> headline_quantities(Experiment experiment) {
  std::vector<CycleQuantity> quantities = cycle_quantities(experiment);
  std::erase_if(quantities, [](const CycleQuantity& quantity) {
    return std::find(headlines.begin(), headlines.end(), quantity.name) == headlines.end();
  });
  return quantities;
}

/// One block of the table: a direction, or a cycle of a strip.
class Block {
 public:
  Block(const Sweep& sweep, const std::vector<SweepPoint>& points, std::size_t cycle)
      : sweep_(sweep), points_(points), cycle_(cycle), quantities_(headline_quantities(sweep.experiment)) {}

  /// "-X"; absent if no point has begun it.
  [[nodiscard]] std::optional<std::string> name() const {
    for (const SweepPoint& point : points_) {
      if (cycle_ < point.result.cycles.size()) return cycle_name(point.result, cycle_);
    }
    return std::nullopt;
  }

  /// A line for each value of a single key.
  [[nodiscard]] std::string lines() const {
    const SweptKey& swept = sweep_.axes.front().swept;
    std::size_t width = swept.key.size();
    for (const std::string& value : swept.values) width = std::max(width, value.size());
    std::string out = fmt::format("{:<{}}", swept.key, width);
    for (const CycleQuantity& quantity : quantities_) {
      out += fmt::format("  {:>{}}", heading_of(quantity), width_of(quantity));
    }
    out += "  status\n";
    for (std::size_t point = 0; point < points_.size(); ++point) {
      out += fmt::format("{:<{}}", swept.values[point], width);
      for (const CycleQuantity& quantity : quantities_) {
        out += fmt::format("  {:>{}}", number_text(value(quantity, point), quantity.shown.size), width_of(quantity));
      }
      out += fmt::format("  {}\n", status(point));
    }
    return out;
  }

  /// A line for each quantity.
  [[nodiscard]] std::string extremes() const {
    std::string out;
    for (const CycleQuantity& quantity : quantities_) {
      std::optional<std::size_t> smallest;
      std::optional<std::size_t> largest;
      for (std::size_t point = 0; point < points_.size(); ++point) {
        const double number = value(quantity, point);
        if (!std::isfinite(number)) continue;
        if (!smallest || number < value(quantity, *smallest)) smallest = point;
        if (!largest || number > value(quantity, *largest)) largest = point;
      }
      out += extreme_line(heading_of(quantity), "smallest", quantity, smallest);
      out += extreme_line("", "largest", quantity, largest);
    }
    return out;
  }

 private:
  static std::size_t width_of(const CycleQuantity& quantity) {
    return std::max(number_width, heading_of(quantity).size());
  }

  [[nodiscard]] double value(const CycleQuantity& quantity, std::size_t point) const {
    return value_at(quantity, sweep_.cases[point], points_[point], cycle_);
  }

  [[nodiscard]] std::string_view status(std::size_t point) const {
    const std::vector<Cycle>& cycles = points_[point].result.cycles;
    if (cycle_ < cycles.size()) return name_of(cycles[cycle_].status);
    return points_[point].status == RunStatus::interrupted ? name_of(Status::interrupted) : "-";
  }

  [[nodiscard]] std::string extreme_line(std::string_view heading, std::string_view which,
                                         const CycleQuantity& quantity, std::optional<std::size_t> point) const {
    constexpr std::size_t heading_width = 26;
    return fmt::format("{:<{}}{:<9}{:>{}}  {}\n", heading, heading_width, which,
                       point ? number_text(value(quantity, *point), quantity.shown.size) : "-", number_width,
                       point ? "at " + point_name(sweep_, *point) : "");
  }

  const Sweep& sweep_;
  const std::vector<SweepPoint>& points_;
  std::size_t cycle_;
  std::vector<CycleQuantity> quantities_;
};

/// The lines of every point, behind its name.
template <typename LinesOf>
std::vector<std::string> named_lines(const Sweep& sweep, const std::vector<SweepPoint>& points,
                                     const LinesOf& lines_of) {
  std::vector<std::string> all;
  for (std::size_t point = 0; point < points.size(); ++point) {
    for (const std::string& line : lines_of(sweep.cases[point], points[point].result)) {
      all.push_back(fmt::format("{}: {}", point_name(sweep, point), line));
    }
  }
  return all;
}

}  // namespace

std::string sweep_table(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const bool listed = sweep.axes.size() == 1 && points.size() <= most_rows;
  const std::size_t cycles = layout_of(sweep).cycles.values.size();
  std::string out;
  for (std::size_t cycle = 0; cycle < cycles; ++cycle) {
    const Block block(sweep, points, cycle);
    const std::optional<std::string> name = block.name();
    if (!name) continue;
    const std::string_view what = sweep.experiment == Experiment::strip ? "" : "direction ";
    out += fmt::format("{}{}{}\n{}", out.empty() ? "" : "\n", what, *name, listed ? block.lines() : block.extremes());
  }
  return out;
}

std::vector<std::string> failure_lines(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  return named_lines(sweep, points,
                     [](const Case& input, const CycleResult& result) { return failure_lines(input, result); });
}

std::vector<std::string> warning_lines(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  return named_lines(sweep, points,
                     [](const Case& input, const CycleResult& result) { return warning_lines(input, result); });
}

}  // namespace bumpfoil
