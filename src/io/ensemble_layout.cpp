#include "bumpfoil/io/ensemble_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/pads.hpp"
#include "io/absent.hpp"

namespace bumpfoil {
namespace {

/// Quantities of a cycle that ensembles keep: those that need no fields, and do not depend on the machine.
constexpr auto kept = std::to_array<std::string_view>(
    {"status", "max_force", "cross_force_at_max", "initial_force", "initial_journal_load", "initial_elastic_energy",
     "loaded_stiffness", "secant_stiffness", "tangent_stiffness_loading", "tangent_stiffness_unloading", "loop_energy",
     "elastic_energy_at_max", "loss_factor", "specific_damping_capacity", "first_contact", "take_up", "max_residual"});

EnsembleColumn column_of(const CycleQuantity& quantity, const Wording& wording) {
  EnsembleColumn column{.name = std::string(quantity.name),
                        .unit = std::string(quantity.unit),
                        .long_name = spelled(quantity.long_name, wording),
                        .form = quantity.form};
  if (quantity.shown.size > 0.0 && quantity.form.kind == Form::real && !quantity.of_solver) {
    column.label = quantity.label;
    column.shown = quantity.shown;
  }
  column.value = quantity.value;
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
          .value = [i](const Cycle& cycle, const Case&) {
            return i < cycle.clearances.size() ? cycle.clearances[i].displacement.value_or(absent) : absent;
          }};
}

EnsembleColumn largest_load_column() {
  return {.name = "largest_bump_load",
          .unit = "N",
          .long_name = "largest load of a bump at full displacement",
          .form = {},
          .label = "largest bump load",
          .shown = {"N", 1.0},
          .undefined = Undefined::unknown,
          .value = [](const Cycle& cycle, const Case&) {
            return cycle.turning_point ? cycle.turning_point->bump_loads.maxCoeff() : absent;
          }};
}

}  // namespace

EnsembleLayout make_ensemble_layout(const Case& input) {
  EnsembleLayout layout{
      .directions = input.cycle.directions, .columns = {}, .bumps = static_cast<std::size_t>(total_bumps(input))};
  const Wording wording = wording_of(input, Experiment::cycle);
  const std::vector<CycleQuantity> quantities = cycle_quantities(Experiment::cycle);
  for (const std::string_view name : kept) {
    const auto found = std::find_if(quantities.begin(), quantities.end(),
                                    [name](const CycleQuantity& quantity) { return quantity.name == name; });
    BUMPFOIL_ASSERT(found != quantities.end());
    layout.columns.push_back(column_of(*found, wording));
  }
  const std::vector<double>& forces = input.cycle.clearance_forces;
  for (std::size_t i = 0; i < forces.size(); ++i) layout.columns.push_back(clearance_column(forces[i], i));
  layout.columns.push_back(largest_load_column());
  return layout;
}

std::vector<double> make_ensemble_row(const EnsembleLayout& layout, const Case& sampled, const CycleResult& result) {
  BUMPFOIL_ASSERT(result.cycles.size() == layout.directions.size());
  std::vector<double> row;
  row.reserve(layout.width());
  for (const Cycle& cycle : result.cycles) {
    for (const EnsembleColumn& column : layout.columns) row.push_back(column.value(cycle, sampled));
    for (std::size_t bump = 0; bump < layout.bumps; ++bump) {
      row.push_back(cycle.turning_point ? cycle.turning_point->bump_loads[static_cast<Eigen::Index>(bump)] : absent);
    }
  }
  return row;
}

}  // namespace bumpfoil
