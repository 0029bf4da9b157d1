#include "bumpfoil/experiments/cycle/result_netcdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "experiments/cycle/result_layout.hpp"
#include "results/netcdf_provenance.hpp"
#include "results/netcdf_writer.hpp"

namespace bumpfoil {
namespace {

using netCDF::NcDim;
using netCDF::NcVar;

std::vector<double> numbers_along(double first, const NcDim& dim) {
  std::vector<double> numbers(dim.getSize());
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/// Puts a result into a file, variable by variable.
class ResultWriter {
 public:
  ResultWriter(NewNetcdf& file, const Case& input, const CycleResult& result)
      : file_(file),
        input_(input),
        result_(result),
        layout_(make_result_layout(input, result.experiment)),
        wording_(wording_of(input, result.experiment)),
        cycles_(layout_.places.size()),
        increment_(file.add_dim("increment", layout_.increments)),
        bump_(file.add_dim("bump", layout_.bumps)),
        foot_(file.add_dim("foot", layout_.feet)) {
    BUMPFOIL_ASSERT(result.cycles.size() <= cycles_);
    if (!layout_.cycles.values.empty()) of_cycles_ = {file.add_dim(layout_.cycles.name, cycles_)};
    if (layout_.pads > 1) pad_ = file.add_dim("pad", layout_.pads);
  }

  void write_coordinates() {
    constexpr Form whole{Form::whole};
    if (!of_cycles_.empty()) put(layout_.cycles, of_cycles_);
    file_.put_all({"increment", "1", "increment; 0 is the start of the cycle", whole}, {increment_},
                  numbers_along(0.0, increment_));
    file_.put_all(
        {"bump", "1", pad_ ? "bump, counted from the weld, pad after pad" : "bump, counted from the weld", whole},
        {bump_}, numbers_along(1.0, bump_));
    file_.put_all(
        {"foot", "1", fmt::format("foot of the bump foil on the {}, counted from the weld", wording_.carrying), whole},
        {foot_}, numbers_along(1.0, foot_));
    if (pad_) file_.put_all({"pad", "1", "pad, in the order of the case", whole}, {*pad_}, numbers_along(1.0, *pad_));
  }

  void write_geometry() {
    for (const NamedNumbers& scalar : layout_.scalars) put(scalar, {});
    for (const NamedNumbers& numbers : layout_.at_bumps) put(numbers, {bump_});
    for (const NamedNumbers& numbers : layout_.at_feet) put(numbers, {foot_});
    for (const NamedNumbers& numbers : layout_.at_pads) put(numbers, {*pad_});
  }

  void write_cycles() {
    for (const CycleQuantity& quantity : cycle_quantities(result_.experiment)) {
      // A cycle that was never begun did not converge; nothing else is known of it.
      const bool known = quantity.name == "converged";
      std::vector<double> values(cycles_, known ? 0.0 : absent);
      for (std::size_t i = 0; i < result_.cycles.size(); ++i)
        values[layout_.places[i]] = quantity.value(result_.cycles[i], input_);
      if (known) {
        file_.put_all(meaning(quantity, quantity.form), of_cycles_, values);
      } else {
        const NcVar variable = file_.add(meaning(quantity, quantity.form), of_cycles_);
        std::vector<std::size_t> start(of_cycles_.size());
        NewNetcdf::put(variable, start, std::vector<std::size_t>(of_cycles_.size(), cycles_), values);
      }
    }
    for (const LoadQuantity& quantity : load_quantities(result_.experiment)) {
      if (!is_there(quantity.node)) continue;
      const NcVar variable = file_.add(meaning(quantity), of_cycles_and({*node(quantity.node)}));
      for (std::size_t i = 0; i < result_.cycles.size(); ++i) {
        const Vector loads = quantity.values(result_.cycles[i]);
        put_rows(variable, i, {static_cast<std::size_t>(loads.size())}, {loads.begin(), loads.end()});
      }
    }
  }

  void write_increments() {
    for (const IncrementQuantity& quantity : increment_quantities(result_.experiment)) {
      const NcVar variable = add_series(meaning(quantity, quantity.form), Node::foil);
      for (std::size_t i = 0; i < result_.cycles.size(); ++i) {
        const std::vector<Increment>& increments = result_.cycles[i].increments;
        std::vector<double> values(increments.size());
        std::transform(increments.begin(), increments.end(), values.begin(), quantity.value);
        put_rows(variable, i, {increments.size()}, std::move(values));
      }
    }
  }

  void write_fields() {
    for (const FieldQuantity& quantity : field_quantities()) {
      if (!is_there(quantity.node)) continue;
      const NcVar variable = add_series(meaning(quantity, quantity.form), quantity.node);
      for (std::size_t i = 0; i < result_.cycles.size(); ++i) {
        const FieldMatrix values = quantity.values(result_.cycles[i].fields);
        std::vector<std::size_t> count{static_cast<std::size_t>(values.rows())};
        if (node(quantity.node)) count.push_back(static_cast<std::size_t>(values.cols()));
        put_rows(variable, i, count, {values.data(), values.data() + values.size()});
      }
    }
  }

  /// Displacements at which thresholds of the force are reached.
  void write_clearances() {
    const std::vector<double>& forces = input_.cycle.clearance_forces;
    if (result_.experiment != Experiment::cycle || forces.empty()) return;
    const NcDim threshold = file_.add_dim("clearance_force", forces.size());
    file_.put_all({"clearance_force", "N", "force at which a push test would take the journal for touching"},
                  {threshold}, forces);
    const NcVar variable =
        file_.add({"clearance", "m", "displacement at which the direct force first reaches the threshold"},
                  of_cycles_and({threshold}));
    for (std::size_t i = 0; i < result_.cycles.size(); ++i) {
      std::vector<double> values(forces.size(), absent);
      const std::vector<Clearance>& found = result_.cycles[i].clearances;
      std::transform(found.begin(), found.end(), values.begin(),
                     [](const Clearance& clearance) { return clearance.displacement.value_or(absent); });
      put_rows(variable, i, {forces.size()}, std::move(values));
    }
  }

  /// Loops of a path.
  void write_orbits() {
    const std::vector<OrbitLoop>& orbits = result_.cycles.front().orbits;
    if (orbits.empty()) return;
    const NcDim number = file_.add_dim("orbit_number", orbits.size());
    file_.put_all({"orbit_number", "1", "orbit, counted from 1", {Form::whole}}, {number}, numbers_along(1.0, number));
    const auto put_member = [&](const VariableMeaning& meaning, double OrbitLoop::*member) {
      std::vector<double> values(orbits.size());
      std::transform(orbits.begin(), orbits.end(), values.begin(),
                     [member](const OrbitLoop& orbit) { return orbit.*member; });
      file_.put_all(meaning, {number}, values);
    };
    put_member({"loop_energies", "J", "closed integral of force over displacement of each orbit"}, &OrbitLoop::energy);
    put_member({"force_defects", "N", "difference of the forces at both ends of each orbit"}, &OrbitLoop::force_defect);
    put_member({"position_defects", "m", "distance of the positions at both ends of each orbit"},
               &OrbitLoop::position_defect);
  }

  /// Changes of mode, where the solver followed them.
  void write_events() {
    std::vector<double> cycles;
    std::vector<CycleEvent> events;
    for (std::size_t i = 0; i < result_.cycles.size(); ++i) {
      const std::vector<CycleEvent>& more = result_.cycles[i].events;
      if (!of_cycles_.empty()) cycles.insert(cycles.end(), more.size(), layout_.cycles.values[layout_.places[i]]);
      events.insert(events.end(), more.begin(), more.end());
    }
    if (events.empty()) return;
    const NcDim event = file_.add_dim("event", events.size());
    if (!of_cycles_.empty()) {
      file_.put_all({"event_" + layout_.cycles.name, layout_.cycles.unit, layout_.cycles.long_name}, {event}, cycles);
    }
    for (const EventQuantity& quantity : event_quantities()) {
      std::vector<double> values(events.size());
      std::transform(events.begin(), events.end(), values.begin(), quantity.value);
      file_.put_all(meaning(quantity, quantity.form), {event}, values);
    }
  }

 private:
  template <typename Quantity>
  [[nodiscard]] VariableMeaning meaning(const Quantity& quantity, const Form& form = {}) const {
    return {std::string(quantity.name), std::string(quantity.unit), spelled(quantity.long_name, wording_), form};
  }

  [[nodiscard]] NewNetcdf::Dims of_cycles_and(const NewNetcdf::Dims& more) const {
    NewNetcdf::Dims dims = of_cycles_;
    dims.insert(dims.end(), more.begin(), more.end());
    return dims;
  }

  /// Whether there are such nodes.
  [[nodiscard]] bool is_there(Node at) const { return at != Node::pad || pad_; }

  /// Their dimension; none of what is one.
  [[nodiscard]] std::optional<NcDim> node(Node at) const {
    switch (at) {
      case Node::foil:
        return std::nullopt;
      case Node::bump:
        return bump_;
      case Node::foot:
        return foot_;
      case Node::weld:
      case Node::pad:
        break;
    }
    return pad_;
  }

  /// Coordinates that say where they are.
  [[nodiscard]] std::string coordinates(Node at) const {
    if (at == Node::bump) return layout_.bump_coordinates;
    return at == Node::foot ? layout_.foot_coordinates : std::string();
  }

  void put(const NamedNumbers& numbers, const NewNetcdf::Dims& dims) {
    file_.put_all({numbers.name, numbers.unit, numbers.long_name}, dims, numbers.values);
  }

  /// A variable with values for every cycle and increment and, where they are not of the whole foil, for every node.
  NcVar add_series(const VariableMeaning& meaning, Node at) {
    NewNetcdf::Dims dims = of_cycles_and({increment_});
    const std::optional<NcDim> of_nodes = node(at);
    if (of_nodes) dims.push_back(*of_nodes);
    const NcVar variable = file_.add(meaning, dims);
    std::string places = meaning.name == "displacement" ? "" : "displacement";
    if (!coordinates(at).empty()) places += ' ' + coordinates(at);
    if (!places.empty()) variable.putAtt("coordinates", places);
    const std::size_t width = of_nodes ? of_nodes->getSize() : 1;
    // One chunk per cycle, unless it passes a megabyte.
    std::vector<std::size_t> chunk(of_cycles_.size(), 1);
    chunk.insert(chunk.end(), {std::clamp<std::size_t>(131072 / width, 1, increment_.getSize()), width});
    chunk.resize(dims.size());
    variable.setChunking(NcVar::nc_CHUNKED, chunk);
    variable.setCompression(true, true, 1);
    return variable;
  }

  /// Puts the first values of a cycle, as many as `count` in the dimensions after that of the cycles. The rest is
  /// absent.
  void put_rows(const NcVar& variable, std::size_t cycle, std::vector<std::size_t> count,
                std::vector<double> values) const {
    if (values.empty()) return;
    if (!of_cycles_.empty()) count.insert(count.begin(), 1);
    std::vector<std::size_t> start(count.size());
    if (!of_cycles_.empty()) start[0] = layout_.places[cycle];
    NewNetcdf::put(variable, start, count, std::move(values));
  }

  NewNetcdf& file_;
  const Case& input_;
  const CycleResult& result_;
  ResultLayout layout_;
  Wording wording_;
  std::size_t cycles_;         ///< that there are, begun or not
  NewNetcdf::Dims of_cycles_;  ///< none for a path, which is one
  NcDim increment_, bump_, foot_;
  std::optional<NcDim> pad_{};  ///< of several
};

/// What keeps a result from being complete.
std::string message_of(const Case& input, const CycleResult& result, RunStatus status) {
  std::vector<std::string> messages = failure_lines(input, result);
  if (status == RunStatus::interrupted) messages.emplace_back("the run was interrupted by the user or the system");
  return fmt::format("{}", fmt::join(messages, "; "));
}

}  // namespace

std::string result_netcdf(const Case& input, const CycleResult& result, RunStatus status, const Provenance& provenance,
                          std::string_view run_id) {
  try {
    NewNetcdf file;
    add_provenance(file, {.input = input,
                          .command = name_of(result.experiment),
                          .status = status,
                          .message = message_of(input, result, status),
                          .warnings = warning_lines(input, result),
                          .provenance = provenance,
                          .run_id = run_id});
    ResultWriter writer(file, input, result);
    writer.write_coordinates();
    writer.write_geometry();
    writer.write_cycles();
    writer.write_clearances();
    if (result.experiment == Experiment::path) writer.write_orbits();
    writer.write_increments();
    writer.write_fields();
    writer.write_events();
    return file.close();
  } catch (const netCDF::exceptions::NcException& error) {
    throw unbuilt("result.nc", error, "fewer steps or directions take less");
  }
}

}  // namespace bumpfoil
