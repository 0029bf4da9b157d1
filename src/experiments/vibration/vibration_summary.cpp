#include "experiments/vibration/vibration_summary.hpp"

#include <fmt/format.h>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/vibration/vibration_files.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/vibration/vibration_quantities.hpp"
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

Json load_json(const Case& input, const StaticLoad& load) {
  const bool reached = load.status == Status::converged;
  Json json{{"load_x_N", load.load.x()},
            {"load_y_N", load.load.y()},
            {"status", name_of(load.status)},
            {"x_m", reached ? Json(load.position.x()) : Json()},
            {"y_m", reached ? Json(load.position.y()) : Json()},
            {"stuck", matrix_json(load.tangents.unloading)},
            {"further", matrix_json(load.tangents.loading)}};
  if (count_pads(input) > 1) {
    json["pad_forces_x_N"] = pads_json(load.pad_forces.row(0));
    json["pad_forces_y_N"] = pads_json(load.pad_forces.row(1));
  }
  return json;
}

Json vibration_json(const Case& input, const VibrationResult& result, std::size_t i) {
  const VibrationSettings& settings = *input.vibration;
  const auto [load, motion, amplitude] = place_of(settings, i);
  Json json{{"load_x_N", settings.loads[load].x()},
            {"load_y_N", settings.loads[load].y()},
            {motion_key(settings), settings.orbits() ? Json(name_of(static_cast<Sense>(motion)))
                                                     : Json(to_degrees(settings.directions[motion]))},
            {"amplitude_m", settings.amplitudes[amplitude]}};
  for (const VibrationQuantity& quantity : vibration_quantities()) {
    json[quantity.key()] = value_json(quantity.value(result.vibrations[i]), quantity.form);
  }
  json["loop_energies_J"] = result.vibrations[i].cycle.loop_energies;
  if (count_pads(input) > 1) json["max_pad_forces_N"] = pads_json(largest_pad_forces(result.vibrations[i]));
  return json;
}

Json coefficients_json(const LinearFoils& foils, double frequency) {
  Json json{{"load_x_N", foils.load.x()},
            {"load_y_N", foils.load.y()},
            {"amplitude_m", foils.amplitude},
            {"frequency_rad_per_s", frequency}};
  json.update(matrix_json(foils.stiffness));
  const Eigen::Matrix2d damping = foils.damping(frequency);
  for (const auto& [axes, row, column] : matrix_entries) {
    json[fmt::format("c{}_N_s_per_m", axes)] = value_json(damping(row, column));
  }
  for (const LinearQuantity& quantity : linear_quantities()) {
    json[quantity.key()] = value_json(quantity.value(foils));
  }
  return json;
}

}  // namespace

Json vibration_lists(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all) {
  Json json;
  for (const char* list : {"loads", "vibrations", "coefficients"}) json[list] = Json::array();
  for (const StaticLoad& load : result.loads) json["loads"].push_back(load_json(input, load));
  for (std::size_t i = 0; i < result.vibrations.size(); ++i) {
    json["vibrations"].push_back(vibration_json(input, result, i));
  }
  for (const LinearFoils& foils : all) {
    for (const double frequency : input.vibration->frequencies)
      json["coefficients"].push_back(coefficients_json(foils, frequency));
  }
  return json;
}

}  // namespace bumpfoil
