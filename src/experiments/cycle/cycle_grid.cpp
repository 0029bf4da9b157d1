#include "experiments/cycle/cycle_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/cycle/result_layout.hpp"
#include "results/csv_value.hpp"

namespace bumpfoil {
namespace {

/// What tables of sweeps show.
constexpr std::array<std::string_view, 4> headlines{"max_force", "loaded_stiffness", "loop_energy", "loss_factor"};

/// Not a number where it is not known.
double value_of(const CycleQuantity& quantity, const Case& input, const CycleResult& result, RunStatus status,
                std::size_t cycle) {
  if (cycle < result.cycles.size()) return quantity.value(result.cycles[cycle], input);
  if (quantity.name == "converged") return 0.0;
  if (quantity.name == "status" && status == RunStatus::interrupted) return static_cast<double>(Status::interrupted);
  return absent;
}

/// Describes cycles, variable by variable.
class CycleGrid {
 public:
  CycleGrid(const Case& input, const CycleResult& result)
      : input_(input),
        result_(result),
        wording_(wording_of(input, result.experiment)),
        layout_(make_result_layout(input, result.experiment)) {
    const NamedNumbers& cycles = layout_.cycles;
    grid_.dims = {{cycles.name, cycles.values.size()}};
    add_coordinate({cycles.name, cycles.unit, cycles.long_name}, cycles.name, cycles.values);
  }

  void add_quantities(RunStatus status) {
    for (const CycleQuantity& quantity : cycle_quantities(result_.experiment)) {
      std::vector<double> values(layout_.places.size());
      for (std::size_t cycle = 0; cycle < values.size(); ++cycle) {
        values[layout_.places[cycle]] = value_of(quantity, input_, result_, status, cycle);
      }
      GridVariable& variable = add(quantity.name, quantity.unit, quantity.long_name, {}, std::move(values));
      variable.meaning.form = quantity.form;
      if (std::find(headlines.begin(), headlines.end(), quantity.name) == headlines.end()) continue;
      variable.heading = quantity.label;
      variable.shown = quantity.shown;
    }
  }

  /// Displacements at which thresholds of the force are reached.
  void add_clearances() {
    const std::vector<double>& forces = input_.cycle.clearance_forces;
    if (result_.experiment == Experiment::strip || forces.empty()) return;
    grid_.dims.push_back({"clearance_force", forces.size()});
    add_coordinate({"clearance_force", "N", "force at which a push test would take the journal for touching"},
                   "clearance_force", forces);
    add("clearance", "m", "displacement at which the direct force first reaches the threshold", {"clearance_force"},
        blocks(forces.size(), [](const Cycle& cycle) {
          std::vector<double> found(cycle.clearances.size());
          std::transform(cycle.clearances.begin(), cycle.clearances.end(), found.begin(),
                         [](const Clearance& clearance) { return clearance.displacement.value_or(absent); });
          return found;
        }));
  }

  void add_loops() {
    grid_.dims.push_back({"increment", layout_.increments});
    add_coordinate({"increment", "1", "increment; 0 is the start of the cycle", {Form::whole}}, "increment",
                   numbers_from(0.0, layout_.increments));
    for (const IncrementQuantity& quantity : increment_quantities(result_.experiment)) {
      const bool is_force = quantity.name == "force_direct";
      if (!is_force && quantity.name != "displacement") continue;
      add(quantity.name, quantity.unit, quantity.long_name, {"increment"},
          blocks(layout_.increments,
                 [&quantity](const Cycle& cycle) {
                   std::vector<double> values(cycle.increments.size());
                   std::transform(cycle.increments.begin(), cycle.increments.end(), values.begin(), quantity.value);
                   return values;
                 }))
          .coordinates = is_force ? "displacement" : "";
    }
  }

  ResultGrid take() { return std::move(grid_); }

 private:
  void add_coordinate(VariableMeaning meaning, const std::string& dim, std::vector<double> values) {
    grid_.coordinates.push_back({std::move(meaning), {dim}, std::move(values)});
  }

  /// @param inside  dimensions after that of the cycles
  GridVariable& add(std::string_view name, std::string_view unit, std::string_view long_name,
                    std::vector<std::string> inside, std::vector<double> values) {
    inside.insert(inside.begin(), layout_.cycles.name);
    return grid_.variables.emplace_back(GridVariable{
        {std::string(name), std::string(unit), spelled(long_name, wording_)}, std::move(inside), std::move(values)});
  }

  /// Numbers of every cycle, so many of each; what is missing is absent. @param numbers_of  a cycle that was begun
  template <typename NumbersOf>
  [[nodiscard]] std::vector<double> blocks(std::size_t size, const NumbersOf& numbers_of) const {
    if (result_.cycles.empty()) return {};
    std::vector<double> all(layout_.places.size() * size, absent);
    for (std::size_t cycle = 0; cycle < result_.cycles.size(); ++cycle) {
      const std::vector<double> numbers = numbers_of(result_.cycles[cycle]);
      std::copy(numbers.begin(), numbers.end(),
                all.begin() + static_cast<std::ptrdiff_t>(layout_.places[cycle] * size));
    }
    return all;
  }

  const Case& input_;
  const CycleResult& result_;
  Wording wording_;
  ResultLayout layout_;
  ResultGrid grid_;
};

}  // namespace

ResultGrid cycle_grid(const Case& input, const CycleResult& result, RunStatus status, bool with_loops) {
  CycleGrid grid(input, result);
  grid.add_quantities(status);
  grid.add_clearances();
  if (with_loops) grid.add_loops();
  return grid.take();
}

std::string cycle_rows(const Case& input, const CycleResult& result, RunStatus status) {
  const std::vector<CycleQuantity> quantities = cycle_quantities(result.experiment);
  const ResultLayout layout = make_result_layout(input, result.experiment);
  std::string out(cycle_key(result.experiment));
  for (const CycleQuantity& quantity : quantities) out += ',' + key_of(quantity.name, quantity.unit);
  for (std::size_t cycle = 0; cycle < layout.places.size(); ++cycle) {
    fmt::format_to(std::back_inserter(out), "\n{:.17g}", layout.cycles.values[layout.places[cycle]]);
    for (const CycleQuantity& quantity : quantities) {
      append_csv(out += ',', value_of(quantity, input, result, status, cycle), quantity.form);
    }
  }
  return out + '\n';
}

}  // namespace bumpfoil
