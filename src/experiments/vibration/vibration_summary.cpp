#include "experiments/vibration/vibration_summary.hpp"

#include <fmt/format.h>

#include "bumpfoil/experiments/vibration/vibration_table.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
#include "experiments/vibration/vibration_tables.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json matrix_json(const std::optional<Eigen::Matrix2d>& K) {
  if (!K) return {};
  Json json;
  for (const auto& [axes, row, column] : matrix_entries) {
    json[fmt::format("k{}_N_per_m", axes)] = value_json((*K)(row, column));
  }
  return json;
}

/// Values per pad; null if unknown.
Json pads_json(const Vector& forces) {
  Json json;
  for (const double force : forces) json.push_back(value_json(force));
  return json;
}

}  // namespace

Json vibration_lists(const Case& input, const VibrationResult& result, const Dataset& data) {
  const bool several = count_pads(input) > 1;
  std::vector<Json> loads =
      rows_json(table_of(data, {.over = {"load"}, .columns = {"load_x", "load_y", "load_status", "x", "y"}}));
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const StaticLoad& load = result.loads[i];
    loads[i].update({{"stuck", matrix_json(load.tangents.unloading)}, {"further", matrix_json(load.tangents.loading)}});
    if (!several) continue;
    loads[i].update(
        {{"pad_forces_x_N", pads_json(load.pad_forces.row(0))}, {"pad_forces_y_N", pads_json(load.pad_forces.row(1))}});
  }
  std::vector<Json> vibrations = rows_json(loop_table(data, input.settings.get<VibrationSettings>()));
  for (std::size_t i = 0; i < vibrations.size(); ++i) {
    vibrations[i]["loop_energies_J"] = result.vibrations[i].cycle.loop_energies;
    if (several) vibrations[i]["max_pad_forces_N"] = pads_json(largest_pad_forces(result.vibrations[i]));
  }
  return {{"loads", loads}, {"vibrations", vibrations}, {"coefficients", rows_json(coefficient_table(data))}};
}

}  // namespace bumpfoil
