#include "support/reference_cycles.hpp"

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "support/json_data.hpp"

namespace bumpfoil {
namespace {

const nlohmann::json& truss_data() {
  static const nlohmann::json parsed = json_data("truss_cycles.json");
  return parsed;
}

std::vector<ReferenceCycle> read_cycles() {
  std::vector<ReferenceCycle> cycles;
  for (const nlohmann::json& entry : truss_data().at("cycles")) {
    ReferenceCycle cycle;
    cycle.name = entry.at("name");
    cycle.input = case_with_given_constants();
    const double f = entry.at("friction_coefficient");
    cycle.input.friction = {.top_bump = f, .bump_sleeve = f};
    cycle.input.bump_foil.height_errors = entry.at("height_errors_m").get<std::vector<double>>();
    cycle.input.settings.get<CycleSettings>().directions = {entry.at("direction_deg").get<double>() * degree};
    cycle.force_direct = to_vector(entry.at("force_direct_N"));
    cycle.force_cross = to_vector(entry.at("force_cross_N"));
    cycle.max_force = entry.at("max_force_N");
    cycle.loop_energy = entry.at("loop_energy_J");
    cycle.bump_loads = to_vector(entry.at("bump_loads_N"));
    cycle.foot_loads = to_vector(entry.at("foot_loads_N"));
    cycle.journal_loads = to_vector(entry.at("journal_loads_N"));
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

}  // namespace

const std::vector<ReferenceCycle>& reference_cycles() {
  static const std::vector<ReferenceCycle> cycles = read_cycles();
  return cycles;
}

Case case_with_given_constants() {
  Case input = reference_case();
  const nlohmann::json& truss = truss_data().at("truss");
  input.bump_foil.truss = {.k1 = truss.at("k1_N_per_m").get<double>(),
                           .k2 = truss.at("k2_N_per_m").get<double>(),
                           .k3 = truss.at("k3_N_per_m").get<double>(),
                           .k4 = truss.at("k4_N_per_m").get<double>(),
                           .theta_d = truss.at("theta_d_deg").get<double>() * degree};
  CycleSettings& cycle = input.settings.get<CycleSettings>();
  cycle.amplitude.value = truss_data().at("amplitude_m");
  cycle.steps = truss_data().at("steps");
  return input;
}

}  // namespace bumpfoil
