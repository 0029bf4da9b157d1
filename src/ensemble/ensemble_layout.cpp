#include "bumpfoil/ensemble/ensemble_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/ensemble/running_sample.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/rotor_speeds.hpp"

namespace bumpfoil {
namespace {

/// A value of one cycle.
template <typename Value>
auto of_cycle(Value value) {
  return [value](const SampleResult& result, std::size_t place, const Case& sampled) {
    return value(std::get<CycleResult>(result).cycles[place], sampled);
  };
}

/// The terminal shows numbers only.
VariableMeaning sampled_meaning(VariableMeaning meaning) {
  const bool listed = meaning.form.kind == Form::real && meaning.shown.size > 0.0;
  if (!listed || (meaning.tags & tag::of_solver) != 0) meaning.label.clear();
  return meaning;
}

EnsembleColumn column_of(const CycleQuantity& quantity, const Wording& wording) {
  VariableMeaning meaning = sampled_meaning(quantity.meaning());
  meaning.long_name = spelled(quantity.long_name, wording);
  return {.meaning = std::move(meaning), .value = of_cycle(quantity.value)};
}

EnsembleColumn clearance_column(VariableMeaning meaning, std::size_t i) {
  return {.meaning = std::move(meaning),
          .undefined = Undefined::largest,
          .value = of_cycle([i](const Cycle& cycle, const Case&) { return clearance_of(cycle, i); })};
}

EnsembleColumn largest_load_column() {
  return {.meaning = {.name = "largest_bump_load",
                      .unit = "N",
                      .long_name = "maximum load of a bump at full displacement",
                      .label = "maximum bump load",
                      .shown = shown::newtons},
          .value = of_cycle([](const Cycle& cycle, const Case&) {
            return cycle.turning_point ? cycle.turning_point->bump_loads.maxCoeff() : absent;
          })};
}

EnsembleColumn column_of(const RunningQuantity& quantity) {
  return {.meaning = sampled_meaning(quantity.meaning()),
          .value = [quantity](const SampleResult& result, std::size_t place, const Case&) {
            const auto& running = std::get<EquilibriumResult>(result);
            return value_of(quantity, *running.bearing, running.states[place]);
          }};
}

/// Without an onset a rotor is stable at all speeds, or at none: stable_up_to distinguishes them.
EnsembleColumn rotor_column(const VariableMeaning& meaning, std::size_t i) {
  return {.meaning = sampled_meaning(meaning),
          .limitable = !meaning.name.starts_with("onset_"),
          .value = [i](const SampleResult& result, std::size_t /*place*/, const Case&) {
            return std::get<std::vector<double>>(result)[i];
          }};
}

/// Adds the quantities that ensembles store; the status comes first. @param add  (quantity)
template <typename Quantities, typename Add>
void add_sampled(const Quantities& quantities, const Add& add) {
  for (const bool status : {true, false}) {
    for (const auto& quantity : quantities) {
      if (quantity.is(tag::sampled) && (quantity.name == "status") == status) add(quantity);
    }
  }
}

void lay_out_cycles(const Case& input, EnsembleLayout& layout) {
  for (const double direction : input.cycle.directions) layout.places.push_back({direction_name(direction), direction});
  const Wording wording = wording_of(input, Experiment::cycle);
  const bool over_width = input.varies_over_the_width() || strips_drawn_apart(input) > 1;
  add_sampled(cycle_quantities(Experiment::cycle, over_width),
              [&](const CycleQuantity& quantity) { layout.columns.push_back(column_of(quantity, wording)); });
  const std::vector<VariableMeaning> clearances = clearance_quantities(input.cycle.clearance_forces);
  for (std::size_t i = 0; i < clearances.size(); ++i) layout.columns.push_back(clearance_column(clearances[i], i));
  layout.columns.push_back(largest_load_column());
}

void lay_out_states(const Case& input, EnsembleLayout& layout) {
  // Errors that every bearing would have are those of the case, not of a sample.
  const FilmBearing bearing = require_running_bearing(input);
  for (const RunningState& state : planned_states(*input.equilibrium, Status::not_reached)) {
    layout.places.push_back({name_of_point(state.requested), state.requested});
  }
  const bool by_load = !input.equilibrium->loads.empty();
  add_sampled(running_quantities(bearing, input.montecarlo->limits), [&](const RunningQuantity& quantity) {
    // Requested values do not scatter.
    const bool requested = by_load ? quantity.name.starts_with("force_") : quantity.name == "x" || quantity.name == "y";
    if (!requested) layout.columns.push_back(column_of(quantity));
  });
}

void lay_out_rotor(const Case& input, EnsembleLayout& layout) {
  const Outcome none = experiment_named(name_of(layout.command)).sweeping->not_begun(input);  // throws, as above
  const Dataset run = none.dataset();
  layout.places.push_back({"rotor"});
  for (const Variable* variable : sampled_variables(run)) {
    layout.columns.push_back(rotor_column(variable->meaning, layout.columns.size()));
  }
}

[[maybe_unused]] std::size_t places_run(const SampleResult& result) {  // only in assertions
  if (const auto* cycles = std::get_if<CycleResult>(&result)) return cycles->cycles.size();
  if (const auto* running = std::get_if<EquilibriumResult>(&result)) return running->states.size();
  return 1;
}

/// Values for the bumps of all strips of a split top foil together.
Vector of_all_strips(const FilmBearing& bearing, const Vector& loads) {
  if (!bearing.has_slits()) return loads;
  std::vector<double> sums;
  Eigen::Index first = 0;
  for (std::size_t k = 0; k < bearing.pads.size(); ++k) {
    const Eigen::Index bumps = bearing.pads[k].bumps();
    if (bearing.placed[k].strip == 0) sums.resize(sums.size() + static_cast<std::size_t>(bumps));
    Eigen::Map<Vector>(sums.data(), std::ssize(sums)).tail(bumps) += loads.segment(first, bumps);
    first += bumps;
  }
  return Eigen::Map<Vector>(sums.data(), std::ssize(sums));
}

/// Empty if unknown.
Vector bump_loads(const SampleResult& result, std::size_t place) {
  if (const auto* cycles = std::get_if<CycleResult>(&result)) {
    const auto& turning_point = cycles->cycles[place].turning_point;
    return turning_point ? turning_point->bump_loads : Vector();
  }
  const auto* running = std::get_if<EquilibriumResult>(&result);
  if (running == nullptr) return {};
  const RunningState& state = running->states[place];
  return state.found() ? of_all_strips(*running->bearing, bumpfoil::bump_loads(*running->bearing, *state.last))
                       : Vector();
}

/// Statuses of a command, followed by that of invalid samples.
template <const Form& statuses>
constexpr auto sample_statuses = [] {
  std::array<std::string_view, statuses.words.size() + 1> names;
  std::copy(statuses.words.begin(), statuses.words.end(), names.begin());
  names.back() = "not_physical";
  return names;
}();

}  // namespace

std::string_view EnsembleLayout::dimension() const {
  if (command == EnsembleCommand::cycle) return "direction";
  return command == EnsembleCommand::equilibrium ? "state" : "rotor";
}

std::string_view EnsembleLayout::leading() const {
  constexpr std::array<std::string_view, 5> names{"max_force", "h_min", "stable_up_to", "largest_amplitude",
                                                  "largest_half_peak_to_peak"};
  return names.at(static_cast<std::size_t>(command));
}

std::string_view EnsembleLayout::status_name(int status) const {
  return columns.front().meaning.form.words[static_cast<std::size_t>(status)];
}

std::string_view EnsembleLayout::status_reason(int status) const {
  if (status == no_bearing()) return "invalid sample";
  return explanation(command == EnsembleCommand::equilibrium ? running_statuses.at(static_cast<std::size_t>(status))
                                                             : static_cast<Status>(status));
}

EnsembleLayout make_ensemble_layout(const Case& input) {
  EnsembleLayout layout{.command = input.montecarlo->command,
                        .places = {},
                        .columns = {},
                        .bumps = static_cast<std::size_t>(total_bumps(input))};
  std::span<const std::string_view> statuses;
  switch (layout.command) {
    case EnsembleCommand::cycle:
      lay_out_cycles(input, layout);
      statuses = sample_statuses<flags<Status>>;
      break;
    case EnsembleCommand::equilibrium:
      lay_out_states(input, layout);
      statuses = sample_statuses<running_status>;
      break;
    case EnsembleCommand::stability:
    case EnsembleCommand::unbalance:
    case EnsembleCommand::transient:
      lay_out_rotor(input, layout);
      statuses = sample_statuses<search_status>;
      break;
  }
  layout.columns.front().meaning.form.words = statuses;
  layout.loads = layout.dimension() == "rotor" ? 0 : layout.bumps;
  return layout;
}

std::vector<double> make_ensemble_row(const EnsembleLayout& layout, const Case& sampled, const SampleResult& result) {
  if (std::holds_alternative<std::monostate>(result)) {
    std::vector<double> nothing(layout.width(), absent);
    for (std::size_t place = 0; place < layout.places.size(); ++place) {
      nothing[layout.entry(place, 0)] = layout.no_bearing();
    }
    return nothing;
  }
  BUMPFOIL_ASSERT(places_run(result) == layout.places.size());
  std::vector<double> row;
  row.reserve(layout.width());
  for (std::size_t place = 0; place < layout.places.size(); ++place) {
    for (const EnsembleColumn& column : layout.columns) row.push_back(column.value(result, place, sampled));
    const Vector loads = bump_loads(result, place);
    for (std::size_t bump = 0; bump < layout.loads; ++bump) {
      row.push_back(loads.size() > 0 ? loads[static_cast<Eigen::Index>(bump)] : absent);
    }
  }
  return row;
}

}  // namespace bumpfoil
