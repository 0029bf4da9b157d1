#include "bumpfoil/experiments/cycle/cycle_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

constexpr std::size_t cycle_columns_per_block = 6;
constexpr std::size_t cycle_name_width = 30;
constexpr std::size_t cycle_unit_width = 7;
constexpr std::size_t least_column_width = 13;

/// Cycles in the table: all directions; for many cycles of a strip the first and the last, which show how it settles.
std::vector<std::size_t> shown_cycles(const CycleResult& result) {
  std::vector<std::size_t> shown(result.cycles.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  if (result.experiment == Experiment::strip && shown.size() > cycle_columns_per_block) {
    shown.erase(shown.begin() + cycle_columns_per_block / 2, shown.end() - cycle_columns_per_block / 2);
  }
  return shown;
}

struct CycleRow {
  std::string name;
  std::string_view unit;
  std::function<std::string(const Cycle&)> cell;
};

std::string cell_text(const CycleQuantity& quantity, double value) {
  if (!quantity.form.words.empty()) return std::string(quantity.form.words[static_cast<std::size_t>(value)]);
  if (quantity.form.kind == Form::whole) return fmt::format("{}", value);
  return number_text(value, quantity.shown.size);
}

/// Displacement at which the direct force first reaches each threshold of the case.
std::vector<CycleRow> rows_of_clearances(const Case& input) {
  std::vector<CycleRow> rows;
  for (const VariableMeaning& clearance : clearance_quantities(input.cycle.clearance_forces)) {
    rows.push_back(
        {clearance.label, clearance.shown.name, [i = rows.size(), size = clearance.shown.size](const Cycle& cycle) {
           return number_text(clearance_of(cycle, i), size);
         }});
  }
  return rows;
}

/// Rows of solver quantities, or of results.
std::vector<CycleRow> rows_of(const Case& input, const CycleResult& result, bool of_solver) {
  std::vector<CycleRow> rows;
  for (const CycleQuantity& quantity : cycle_quantities(result.experiment, result.over_width)) {
    if (quantity.shown.size == 0.0 || quantity.is(tag::of_solver) != of_solver) continue;
    rows.push_back({std::string(quantity.label), quantity.shown.name, [quantity, &input](const Cycle& cycle) {
                      return cell_text(quantity, quantity.value(cycle, input));
                    }});
    for (const StressedFoil& foil : stressed_foils()) {
      if (quantity.name != fmt::format("max_stress_{}", foil.name)) continue;
      rows.push_back({"  at", "", [peak = foil.peak, &input](const Cycle& cycle) {
                        const std::optional<StressPeak>& highest = cycle.*peak;
                        return highest && highest->stress > 0.0 ? place_text(input, *highest) : "-";
                      }});
    }
  }
  return rows;
}

/// The bump with the largest load at full displacement.
std::vector<CycleRow> rows_of_highest_load(const Case& input) {
  const auto known = [](const Cycle& cycle) {
    return cycle.turning_point && cycle.turning_point->bump_loads.size() > 0;
  };
  const auto load = [known](const Cycle& cycle) {
    return known(cycle) ? number_text(cycle.turning_point->bump_loads.maxCoeff(), 1.0) : "-";
  };
  const auto bump = [known, &input](const Cycle& cycle) {
    Eigen::Index highest = 0;
    const bool any = known(cycle) && cycle.turning_point->bump_loads.maxCoeff(&highest) > 0.0;
    return any ? bump_text(input, static_cast<int>(highest)) : "-";
  };
  return {{"maximum bump load", "N", load}, {"on bump", "", bump}};
}

Vector pad_forces_at_turn(const Cycle& cycle) {
  if (!cycle.turning_point) return {};
  const TurningPoint& turn = *cycle.turning_point;
  return (turn.pad_forces_x.array().square() + turn.pad_forces_y.array().square()).sqrt();
}

/// Fraction of the force on each of several pads at full displacement; of a path, the maximum.
std::vector<CycleRow> rows_of_pads(const Case& input, Experiment experiment) {
  const bool turns = experiment != Experiment::path;
  std::vector<CycleRow> rows;
  if (count_pads(input) == 1) return rows;
  rows.reserve(count_pads(input));
  for (std::size_t k = 0; k < count_pads(input); ++k) {
    rows.push_back({fmt::format("{}force of pad {}", turns ? "" : "maximum ", k + 1), "N",
                    [turns, pad = static_cast<Eigen::Index>(k)](const Cycle& cycle) {
                      const Vector forces = turns ? pad_forces_at_turn(cycle) : cycle.largest_pad_forces;
                      return pad < forces.size() ? number_text(forces[pad], 1.0) : std::string("-");
                    }});
  }
  return rows;
}

}  // namespace

std::string cycle_table(const Case& input, const CycleResult& result) {
  const std::vector<std::size_t> shown = shown_cycles(result);
  std::vector<CycleRow> rows = rows_of(input, result, false);
  const std::vector<CycleRow> clearances =
      result.experiment == Experiment::cycle ? rows_of_clearances(input) : std::vector<CycleRow>{};
  const bool turns = result.experiment != Experiment::path;
  const std::vector<CycleRow> highest_load = turns ? rows_of_highest_load(input) : std::vector<CycleRow>{};
  const std::vector<CycleRow> pads = rows_of_pads(input, result.experiment);
  for (const std::vector<CycleRow>& more : {clearances, pads, highest_load, rows_of(input, result, true)}) {
    rows.insert(rows.end(), more.begin(), more.end());
  }
  std::size_t column_width = least_column_width;
  for (CycleRow& row : rows) {
    std::vector<std::string> cells;
    for (const std::size_t cycle : shown) {
      cells.push_back(row.cell(result.cycles[cycle]));
      column_width = std::max(column_width, cells.back().size() + 1);
    }
    row.unit = unit_beside(row.unit, cells);
  }
  std::string out;
  for (std::size_t first = 0; first < shown.size(); first += cycle_columns_per_block) {
    const std::size_t end = std::min(first + cycle_columns_per_block, shown.size());
    if (!out.empty()) out += '\n';
    const auto append = [&](std::string_view name, std::string_view unit, const auto& cell) {
      out += fmt::format("{:<{}}{:<{}}", name, cycle_name_width, unit, cycle_unit_width);
      for (std::size_t i = first; i < end; ++i) out += fmt::format("{:>{}}", cell(shown[i]), column_width);
      out += '\n';
    };
    append(result.experiment == Experiment::cycle ? "direction" : "", "",
           [&](std::size_t cycle) { return cycle_name(result, cycle); });
    out += std::string(cycle_name_width + cycle_unit_width + column_width * (end - first), '-') + '\n';
    for (const CycleRow& row : rows) {
      append(row.name, row.unit, [&](std::size_t cycle) { return row.cell(result.cycles[cycle]); });
    }
  }
  if (shown.size() < result.cycles.size()) {
    out += fmt::format("cycles {} to {} are in the files only\n", cycle_columns_per_block / 2 + 1,
                       result.cycles.size() - cycle_columns_per_block / 2);
  }
  return out;
}

}  // namespace bumpfoil
