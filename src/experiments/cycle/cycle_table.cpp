#include "bumpfoil/experiments/cycle/cycle_table.hpp"

#include <fmt/format.h>

#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "results/table_lines.hpp"

namespace bumpfoil {
namespace {

/// Of many cycles of a strip only the first and the last are shown: how it settles.
constexpr std::size_t most_cycles_shown = 6;

/// Cycles in the table: all directions; for many cycles of a strip the first and the last.
std::vector<std::size_t> shown_cycles(const CycleResult& result) {
  std::vector<std::size_t> shown(result.cycles.size());
  std::iota(shown.begin(), shown.end(), std::size_t{0});
  if (result.experiment == Experiment::strip && shown.size() > most_cycles_shown) {
    shown.erase(shown.begin() + most_cycles_shown / 2, shown.end() - most_cycles_shown / 2);
  }
  return shown;
}

/// Table of some cycles: one row each.
class CycleTable {
 public:
  CycleTable(const Case& input, const CycleResult& result, const std::vector<std::size_t>& shown)
      : input_(input), result_(result) {
    for (const std::size_t i : shown) cycles_.push_back(&result.cycles[i]);
    table_.add(shown_column(result.experiment == Experiment::cycle ? "direction" : ""),
               each(shown, [&](std::size_t i) { return cycle_name(result, i); }));
  }

  /// Quantities of the solver, or of results.
  void add_quantities(bool of_solver) {
    for (const CycleQuantity& quantity : cycle_quantities(result_.experiment, result_.over_width)) {
      if (quantity.shown.size == 0.0 || quantity.is(tag::of_solver) != of_solver) continue;
      add(quantity.meaning(), [&](const Cycle& cycle) { return quantity.value(cycle, input_); });
      for (const StressedFoil& foil : stressed_foils()) {
        if (quantity.name != fmt::format("max_stress_{}", foil.name)) continue;
        add(shown_column(fmt::format("{}: at", quantity.label)), [&](const Cycle& cycle) -> std::string {
          const std::optional<StressPeak>& highest = cycle.*foil.peak;
          return highest && highest->stress > 0.0 ? place_text(input_, *highest) : "-";
        });
      }
    }
  }

  /// Displacement at which the direct force first reaches each threshold of the case.
  void add_clearances() {
    if (result_.experiment != Experiment::cycle) return;
    const std::vector<VariableMeaning> clearances =
        clearance_quantities(input_.settings.get<CycleSettings>().clearance_forces);
    for (std::size_t i = 0; i < clearances.size(); ++i) {
      add(clearances[i], [i](const Cycle& cycle) { return clearance_of(cycle, i); });
    }
  }

  /// Fraction of the force on each of several pads at full displacement; of a path, the maximum.
  void add_pads() {
    const bool turns = result_.experiment != Experiment::path;
    const std::size_t pads = count_pads(input_) > 1 ? count_pads(input_) : 0;
    for (std::size_t k = 0; k < pads; ++k) {
      add(shown_column(fmt::format("{}force of pad {}", turns ? "" : "maximum ", k + 1), shown::newtons),
          [turns, pad = static_cast<Eigen::Index>(k)](const Cycle& cycle) {
            const Vector forces = turns ? pad_forces_at_turn(cycle) : cycle.largest_pad_forces;
            return pad < forces.size() ? forces[pad] : absent;
          });
    }
  }

  /// The bump with the largest load at full displacement.
  void add_highest_load() {
    if (result_.experiment == Experiment::path) return;
    const auto known = [](const Cycle& cycle) {
      return cycle.turning_point && cycle.turning_point->bump_loads.size() > 0;
    };
    add(shown_column("maximum bump load", shown::newtons),
        [known](const Cycle& cycle) { return known(cycle) ? cycle.turning_point->bump_loads.maxCoeff() : absent; });
    add(shown_column("maximum bump load: on bump"), [known, this](const Cycle& cycle) -> std::string {
      Eigen::Index highest = 0;
      const bool any = known(cycle) && cycle.turning_point->bump_loads.maxCoeff(&highest) > 0.0;
      return any ? bump_text(input_, static_cast<int>(highest)) : "-";
    });
  }

  [[nodiscard]] std::string text() const { return table_blocks(table_); }

 private:
  static Vector pad_forces_at_turn(const Cycle& cycle) {
    if (!cycle.turning_point) return {};
    const TurningPoint& turn = *cycle.turning_point;
    return (turn.pad_forces_x.array().square() + turn.pad_forces_y.array().square()).sqrt();
  }

  /// @param value  cycle -> number or text
  template <typename Value>
  void add(VariableMeaning meaning, const Value& value) {
    table_.add(std::move(meaning), each(cycles_, [&value](const Cycle* cycle) { return value(*cycle); }));
  }

  const Case& input_;
  const CycleResult& result_;
  std::vector<const Cycle*> cycles_;
  Table table_;
};

}  // namespace

std::string cycle_table(const Case& input, const CycleResult& result) {
  const std::vector<std::size_t> shown = shown_cycles(result);
  CycleTable table(input, result, shown);
  table.add_quantities(false);
  table.add_clearances();
  table.add_pads();
  table.add_highest_load();
  table.add_quantities(true);
  std::string out = table.text();
  if (shown.size() < result.cycles.size()) {
    out += fmt::format("cycles {} to {} are in the files only\n", most_cycles_shown / 2 + 1,
                       result.cycles.size() - most_cycles_shown / 2);
  }
  return out;
}

}  // namespace bumpfoil
