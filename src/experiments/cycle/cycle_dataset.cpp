#include "experiments/cycle/cycle_dataset.hpp"

#include <algorithm>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/cycle/result_layout.hpp"

namespace bumpfoil {
namespace {

using Dims = std::vector<std::string>;

/// The value, or NaN if unknown.
double value_of(const CycleQuantity& quantity, const Case& input, const CycleResult& result, RunStatus status,
                std::size_t cycle) {
  if (cycle < result.cycles.size()) return quantity.value(result.cycles[cycle], input);
  if (quantity.name == "converged") return 0.0;
  if (quantity.name == "status" && status == RunStatus::interrupted) return static_cast<double>(Status::interrupted);
  return absent;
}

/// Describes cycles, one variable at a time.
class CycleDataset {
 public:
  CycleDataset(const Case& input, const CycleResult& result)
      : input_(input),
        result_(result),
        wording_(wording_of(input, result.experiment)),
        layout_(make_result_layout(input, result.experiment)) {
    BUMPFOIL_ASSERT(result.cycles.size() <= layout_.places.size());
    const NamedNumbers& cycles = layout_.cycles;
    if (cycles.values.empty()) return;
    of_cycles_ = {cycles.name};
    data_.add_dimension({cycles.name, cycles.unit, cycles.long_name}, cycles.values);
  }

  void add_increments() {
    if (is_path()) {
      data_.dims.push_back({.name = "increment", .size = layout_.increments, .grows = true});
      data_.coordinates.push_back(
          {.meaning = {"increment", "1", "increment; 0 is the start of the cycle", whole_number},
           .dims = {"increment"},
           .rows = [](std::size_t first, std::size_t count) { return numbers_from(static_cast<double>(first), count); },
           .known = true});
      return;
    }
    data_.add_dimension({"increment", "1", "increment; 0 is the start of the cycle", {Form::whole}},
                        numbers_from(0.0, layout_.increments));
  }

  void add_nodes() { add_foils(layout_, wording_.carrying, data_); }

  void add_quantities(RunStatus status) {
    for (const CycleQuantity& quantity : cycle_quantities(result_.experiment, result_.over_width)) {
      std::vector<double> values(layout_.places.size());
      for (std::size_t cycle = 0; cycle < values.size(); ++cycle) {
        values[layout_.places[cycle]] = value_of(quantity, input_, result_, status, cycle);
      }
      data_.add(meaning(quantity), of_cycles_, std::move(values)).known = quantity.name == "converged";
    }
  }

  void add_loads() {
    for (const LoadQuantity& quantity : load_quantities(result_.experiment)) {
      if (!layout_.has(quantity.node)) continue;
      const Dims dims = layout_.dims_of(quantity.node);
      data_.add(meaning(quantity), of_cycles_and(dims), blocks(data_.size_of(dims.front()), quantity.value));
    }
  }

  /// Displacements at which thresholds of the force are reached.
  void add_clearances() {
    if (result_.experiment != Experiment::cycle) return;
    const std::vector<double>& forces = input_.settings.get<CycleSettings>().clearance_forces;
    if (forces.empty()) return;
    data_.add_dimension({"clearance_force", "N", "force at which a push test would report contact"}, forces);
    data_.add({"clearance", "m", "displacement at which the direct force first reaches the threshold"},
              of_cycles_and({"clearance_force"}), blocks(forces.size(), [](const Cycle& cycle) {
                return each(cycle.clearances, [](const Clearance& one) { return one.displacement.value_or(absent); });
              }));
  }

  /// Loops of a path.
  void add_orbits() {
    if (result_.experiment != Experiment::path || result_.cycles.empty()) return;
    const std::vector<OrbitLoop>& orbits = result_.cycles.front().orbits;
    if (orbits.empty()) return;
    data_.add_dimension({"orbit_number", "1", "orbit, counted from 1", {Form::whole}},
                        numbers_from(1.0, orbits.size()));
    const auto add = [&](const VariableMeaning& meaning, double OrbitLoop::*member) {
      data_.add(meaning, {"orbit_number"}, each(orbits, [member](const OrbitLoop& orbit) { return orbit.*member; }))
          .known = true;
    };
    add({"loop_energies", "J", "closed integral of force over displacement of each orbit"}, &OrbitLoop::energy);
    add({"force_defects", "N", "difference of the forces at both ends of each orbit"}, &OrbitLoop::force_defect);
    add({"position_defects", "m", "distance of the positions at both ends of each orbit"}, &OrbitLoop::position_defect);
  }

  /// @param loops  displacement and force only
  void add_series(bool loops) {
    for (const IncrementQuantity& quantity : increment_quantities(result_.experiment, result_.over_width)) {
      if (loops && quantity.name != "force_direct" && quantity.name != "displacement") continue;
      add_series(meaning(quantity), Node::foil, series(layout_.increments, [quantity](const Cycle& cycle) {
                   return each(cycle.increments, quantity.value);
                 }));
    }
  }

  void add_fields() {
    for (const FieldQuantity& quantity : field_quantities()) {
      if (!layout_.has(quantity.node) || (quantity.is(tag::of_width_alone) && !result_.over_width)) continue;
      const Dims dims = layout_.dims_of(quantity.node);
      const std::size_t width = dims.empty() ? 1 : data_.size_of(dims.front());
      add_series(meaning(quantity), quantity.node, series(layout_.increments * width, [quantity](const Cycle& cycle) {
                   const FieldMatrix values = quantity.value(cycle.fields);
                   return std::vector<double>(values.data(), values.data() + values.size());
                 }));
    }
  }

  /// Mode changes, if the solver followed them.
  void add_events() {
    if (is_path()) {
      data_.dims.push_back({.name = "event", .grows = true});
      for (const EventQuantity& quantity : event_quantities()) {
        Variable& added =
            data_.add(meaning(quantity), {"event"},
                      series(0, [quantity](const Cycle& cycle) { return each(cycle.events, quantity.value); }));
        added.known = added.compressed = true;
      }
      return;
    }
    std::vector<double> cycles;
    std::vector<CycleEvent> events;
    for (std::size_t i = 0; i < result_.cycles.size(); ++i) {
      const std::vector<CycleEvent>& more = result_.cycles[i].events;
      if (!of_cycles_.empty()) cycles.insert(cycles.end(), more.size(), layout_.cycles.values[layout_.places[i]]);
      events.insert(events.end(), more.begin(), more.end());
    }
    if (events.empty()) return;
    data_.dims.push_back({"event", events.size()});
    const NamedNumbers& of = layout_.cycles;
    if (!of_cycles_.empty()) data_.add_coordinate({"event_" + of.name, of.unit, of.long_name}, {"event"}, cycles);
    for (const EventQuantity& quantity : event_quantities()) {
      data_.add(meaning(quantity), {"event"}, each(events, quantity.value)).known = true;
    }
  }

  Dataset take() { return std::move(data_); }

 private:
  [[nodiscard]] bool is_path() const { return result_.experiment == Experiment::path; }

  template <typename Quantity>
  [[nodiscard]] VariableMeaning meaning(const Quantity& quantity) const {
    VariableMeaning meaning = quantity.meaning();
    meaning.long_name = spelled(quantity.long_name, wording_);
    return meaning;
  }

  [[nodiscard]] Dims of_cycles_and(const Dims& more) const {
    Dims dims = of_cycles_;
    dims.insert(dims.end(), more.begin(), more.end());
    return dims;
  }

  /// Values of every cycle and increment and, unless global, of every node.
  void add_series(const VariableMeaning& meaning, Node at, std::function<std::vector<double>()> values) {
    Dims dims = of_cycles_and({"increment"});
    const Dims of_nodes = layout_.dims_of(at);
    dims.insert(dims.end(), of_nodes.begin(), of_nodes.end());
    Variable& added = data_.add(meaning, std::move(dims), std::move(values));
    const std::string places = layout_.coordinates_of(at);
    added.attributes["coordinates"] =
        (meaning.name == "displacement" ? "" : "displacement") + (places.empty() ? "" : ' ' + places);
    added.compressed = true;
  }

  /// The first numbers of every cycle, at most `size`; missing ones are absent. @param numbers_of  a cycle that was
  /// started
  template <typename NumbersOf>
  [[nodiscard]] std::function<std::vector<double>()> blocks(std::size_t size, NumbersOf numbers_of) const {
    return [&result = result_, places = layout_.places, size, numbers_of] {
      if (result.cycles.empty()) return std::vector<double>();
      std::vector<double> all(places.size() * size, absent);
      for (std::size_t cycle = 0; cycle < result.cycles.size(); ++cycle) {
        const auto& numbers = numbers_of(result.cycles[cycle]);
        std::copy(numbers.begin(), numbers.end(), all.begin() + static_cast<std::ptrdiff_t>(places[cycle] * size));
      }
      return all;
    };
  }

  /// Numbers of every cycle, at most `size`; of a path, whose increments are streamed, those in memory.
  template <typename NumbersOf>
  [[nodiscard]] std::function<std::vector<double>()> series(std::size_t size, NumbersOf numbers_of) const {
    if (!is_path()) return blocks(size, numbers_of);
    return [&result = result_, numbers_of] {
      return result.cycles.empty() ? std::vector<double>() : numbers_of(result.cycles.front());
    };
  }

  const Case& input_;
  const CycleResult& result_;
  Wording wording_;
  ResultLayout layout_;
  Dims of_cycles_;  ///< none for a path, which is a single cycle
  Dataset data_;
};

}  // namespace

Dataset cycle_dataset(const Case& input, const CycleResult& result, RunStatus status, Extent extent) {
  CycleDataset data(input, result);
  const bool everything = extent == Extent::everything;
  const bool ended = extent != Extent::recorded;
  const bool recorded = everything || !ended;
  if (recorded) data.add_increments();
  if (recorded || extent == Extent::totals) data.add_nodes();
  if (ended) data.add_quantities(status);
  if (everything || extent == Extent::totals) data.add_loads();
  if (ended) data.add_clearances();
  if (everything || extent == Extent::totals) data.add_orbits();
  if (extent == Extent::loops) data.add_increments();
  if (recorded || extent == Extent::loops) data.add_series(extent == Extent::loops);
  if (recorded) {
    data.add_fields();
    data.add_events();
  }
  return data.take();
}

Table cycle_rows(const Case& input, const CycleResult& result, RunStatus status) {
  const Dataset data = cycle_dataset(input, result, status, Extent::quantities);
  const ResultLayout layout = make_result_layout(input, result.experiment);
  Table table =
      table_of(data, {.over = {layout.cycles.name},
                      .columns = names_of(cycle_quantities(result.experiment, result.over_width), {layout.cycles.name}),
                      .rows = each(layout.places, [](std::size_t place) { return std::vector<std::size_t>{place}; })});
  if (result.experiment != Experiment::cycle) return table;
  const std::vector<VariableMeaning> clearances =
      clearance_quantities(input.settings.get<CycleSettings>().clearance_forces);
  for (std::size_t k = 0; k < clearances.size(); ++k) {
    std::vector<double> values = each(result.cycles, [k](const Cycle& cycle) { return clearance_of(cycle, k); });
    values.resize(layout.places.size(), absent);
    table.add(clearances[k], std::move(values));
  }
  return table;
}

}  // namespace bumpfoil
