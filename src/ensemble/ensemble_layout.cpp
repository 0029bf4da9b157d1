#include "bumpfoil/ensemble/ensemble_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

// Quantities that ensembles keep: those that need no fields, and do not depend on the machine.
constexpr auto kept_of_cycles = std::to_array<std::string_view>(
    {"status", "max_force", "cross_force_at_max", "initial_force", "initial_journal_load", "initial_elastic_energy",
     "loaded_stiffness", "secant_stiffness", "tangent_stiffness_loading", "tangent_stiffness_unloading", "loop_energy",
     "elastic_energy_at_max", "loss_factor", "specific_damping_capacity", "first_contact", "take_up", "max_residual"});

constexpr auto kept_of_states = std::to_array<std::string_view>({"status",
                                                                 "x",
                                                                 "y",
                                                                 "force_x",
                                                                 "force_y",
                                                                 "eccentricity_ratio",
                                                                 "attitude_angle",
                                                                 "h_min",
                                                                 "h_min_theta",
                                                                 "h_min_pad",
                                                                 "h_min_vertex",
                                                                 "h_min_crest",
                                                                 "p_max",
                                                                 "p_min",
                                                                 "torque",
                                                                 "power",
                                                                 "flow_sides",
                                                                 "loaded_bumps",
                                                                 "lifted_bumps_at_entry",
                                                                 "highest_bump_load",
                                                                 "max_stress_top_foil",
                                                                 "max_stress_bump_foil",
                                                                 "kxx",
                                                                 "kxy",
                                                                 "kyx",
                                                                 "kyy",
                                                                 "kxx_whirl",
                                                                 "kxy_whirl",
                                                                 "kyx_whirl",
                                                                 "kyy_whirl",
                                                                 "cxx_whirl",
                                                                 "cxy_whirl",
                                                                 "cyx_whirl",
                                                                 "cyy_whirl",
                                                                 "jumps",
                                                                 "residual",
                                                                 "lift_off_speed",
                                                                 "load_capacity"});

/// A value of one of the cycles.
template <typename Value>
auto of_cycle(Value value) {
  return [value](const SampleResult& result, std::size_t place, const Case& sampled) {
    return value(std::get<CycleResult>(result).cycles[place], sampled);
  };
}

EnsembleColumn column_of(const CycleQuantity& quantity, const Wording& wording) {
  EnsembleColumn column{.name = std::string(quantity.name),
                        .unit = std::string(quantity.unit),
                        .long_name = spelled(quantity.long_name, wording),
                        .form = quantity.form};
  if (quantity.shown.size > 0.0 && quantity.form.kind == Form::real && !quantity.of_solver) {
    column.label = quantity.label;
    column.shown = quantity.shown;
  }
  column.value = of_cycle(quantity.value);
  return column;
}

EnsembleColumn clearance_column(double force, std::size_t i) {
  return {.name = fmt::format("clearance_{:.6g}N", force),
          .unit = "m",
          .long_name = fmt::format("displacement at which the direct force first reaches {:.6g} N", force),
          .form = {},
          .label = fmt::format("clearance at {:.4g} N", force),
          .shown = {"um", 1e-6},
          .undefined = Undefined::largest,
          .value = of_cycle([i](const Cycle& cycle, const Case&) {
            return i < cycle.clearances.size() ? cycle.clearances[i].displacement.value_or(absent) : absent;
          })};
}

EnsembleColumn largest_load_column() {
  return {.name = "largest_bump_load",
          .unit = "N",
          .long_name = "largest load of a bump at full displacement",
          .form = {},
          .label = "largest bump load",
          .shown = {"N", 1.0},
          .undefined = Undefined::unknown,
          .value = of_cycle([](const Cycle& cycle, const Case&) {
            return cycle.turning_point ? cycle.turning_point->bump_loads.maxCoeff() : absent;
          })};
}

EnsembleColumn column_of(const RunningQuantity& quantity) {
  EnsembleColumn column{.name = std::string(quantity.name),
                        .unit = std::string(quantity.unit),
                        .long_name = std::string(quantity.long_name),
                        .form = quantity.form};
  if (quantity.form.kind == Form::real) {
    column.label = quantity.label;
    column.shown = quantity.shown;
  }
  column.value = [quantity](const SampleResult& result, std::size_t place, const Case&) {
    const auto& running = std::get<EquilibriumResult>(result);
    const RunningState& state = running.states[place];
    return value_of(quantity, *running.bearing, state);
  };
  return column;
}

/// Descriptions of the quantities of these names.
template <typename Quantities, typename Names, typename Add>
void add_named(const Quantities& quantities, const Names& names, Add&& add) {
  for (const std::string_view name : names) {
    const auto found = std::find_if(quantities.begin(), quantities.end(),
                                    [name](const auto& quantity) { return quantity.name == name; });
    BUMPFOIL_ASSERT(found != quantities.end());
    add(*found);
  }
}

void lay_out_cycles(const Case& input, EnsembleLayout& layout) {
  for (const double direction : input.cycle.directions) layout.places.push_back({direction_name(direction), direction});
  const Wording wording = wording_of(input, Experiment::cycle);
  add_named(cycle_quantities(Experiment::cycle), kept_of_cycles,
            [&](const CycleQuantity& quantity) { layout.columns.push_back(column_of(quantity, wording)); });
  const std::vector<double>& forces = input.cycle.clearance_forces;
  for (std::size_t i = 0; i < forces.size(); ++i) layout.columns.push_back(clearance_column(forces[i], i));
  layout.columns.push_back(largest_load_column());
}

void lay_out_states(const Case& input, EnsembleLayout& layout) {
  // What no bearing of the case could do is its fault, and not that of what is drawn.
  static_cast<void>(require_running_bearing(input));
  for (const RunningState& state : planned_states(*input.equilibrium, FilmStatus::not_reached)) {
    layout.places.push_back({name_of_point(state.asked), state.asked});
  }
  const bool by_load = !input.equilibrium->loads.empty();
  add_named(all_running_quantities(), kept_of_states, [&](const RunningQuantity& quantity) {
    // What was asked for does not scatter.
    const bool asked = by_load ? quantity.name.starts_with("force_") : quantity.name == "x" || quantity.name == "y";
    if (quantity.of_pads && count_pads(input) == 1) return;
    if (quantity.of_limits && !input.montecarlo->limits) return;
    if (!asked) layout.columns.push_back(column_of(quantity));
  });
}

/// Empty where they are not known.
Vector bump_loads(const SampleResult& result, std::size_t place) {
  if (const auto* cycles = std::get_if<CycleResult>(&result)) {
    const auto& turning_point = cycles->cycles[place].turning_point;
    return turning_point ? turning_point->bump_loads : Vector();
  }
  const auto& running = std::get<EquilibriumResult>(result);
  const RunningState& state = running.states[place];
  return state.found() ? bumpfoil::bump_loads(*running.bearing, *state.last) : Vector();
}

/// Statuses of a command, and behind them that of samples that make no bearing.
template <typename Status>
constexpr auto sample_statuses = [] {
  std::array<std::string_view, enum_names<Status>.size() + 1> names;
  std::copy(enum_names<Status>.begin(), enum_names<Status>.end(), names.begin());
  names.back() = "not_physical";
  return names;
}();

}  // namespace

std::string_view EnsembleLayout::status_name(int status) const {
  return columns.front().form.words[static_cast<std::size_t>(status)];
}

std::string_view EnsembleLayout::status_reason(int status) const {
  if (status == no_bearing()) return "what was drawn makes no bearing";
  return command == EnsembleCommand::cycle ? explanation(static_cast<Status>(status))
                                           : reason_of(static_cast<FilmStatus>(status));
}

EnsembleLayout make_ensemble_layout(const Case& input) {
  EnsembleLayout layout{.command = input.montecarlo->command,
                        .places = {},
                        .columns = {},
                        .bumps = static_cast<std::size_t>(total_bumps(input))};
  if (layout.command == EnsembleCommand::cycle) {
    lay_out_cycles(input, layout);
    layout.columns.front().form.words = sample_statuses<Status>;
  } else {
    lay_out_states(input, layout);
    layout.columns.front().form.words = sample_statuses<FilmStatus>;
  }
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
  [[maybe_unused]] const auto* cycles = std::get_if<CycleResult>(&result);  // by the assertion alone
  BUMPFOIL_ASSERT((cycles ? cycles->cycles.size() : std::get<EquilibriumResult>(result).states.size()) ==
                  layout.places.size());
  std::vector<double> row;
  row.reserve(layout.width());
  for (std::size_t place = 0; place < layout.places.size(); ++place) {
    for (const EnsembleColumn& column : layout.columns) row.push_back(column.value(result, place, sampled));
    const Vector loads = bump_loads(result, place);
    for (std::size_t bump = 0; bump < layout.bumps; ++bump) {
      row.push_back(loads.size() > 0 ? loads[static_cast<Eigen::Index>(bump)] : absent);
    }
  }
  return row;
}

}  // namespace bumpfoil
