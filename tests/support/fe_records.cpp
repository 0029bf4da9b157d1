#include "support/fe_records.hpp"

#include "support/json_data.hpp"

namespace bumpfoil {
namespace {

nlohmann::json rows_of(const std::string& file) {
  return json_data("fe/" + file).at("rows");
}

std::vector<FeCycle> read_fe_cycles() {
  std::vector<FeCycle> cycles;
  for (const nlohmann::json& row : rows_of("full_bearing.json")) {
    if (!row.at("converged").get<bool>()) continue;
    const int steps = row.at("steps");
    cycles.push_back({.variant = row.at("variant"),
                      .friction_coefficient = row.at("friction"),
                      .direction = row.at("direction_deg").get<double>() * degree,
                      .steps = steps,
                      .max_force = row.at("max_force_N"),
                      .cross_force = row.at("force_cross_N").at(static_cast<std::size_t>(steps)),
                      .loop_energy = row.at("loop_energy_J"),
                      .force_direct = to_vector(row.at("force_direct_N")),
                      .bump_loads = to_vector(row.at("bump_loads_N"))});
  }
  return cycles;
}

std::vector<FeStrip> read_strips() {
  std::vector<FeStrip> strips;
  for (const nlohmann::json& row : rows_of("strips.json")) {
    if (!row.at("converged").get<bool>()) continue;
    strips.push_back({.bumps = row.at("bumps"),
                      .friction_coefficient = row.at("friction"),
                      .top_foil = row.at("top_foil"),
                      .large_displacements = row.at("displacements") == "large",
                      .contact_at_nodes = row.at("contact") == "nodes",
                      .max_force = row.at("max_force_N"),
                      .loop_energy = row.at("loop_energy_J"),
                      .bump_loads = to_vector(row.at("bump_loads_N"))});
  }
  return strips;
}

}  // namespace

const std::vector<FeStrip>& fe_strips() {
  static const std::vector<FeStrip> strips = read_strips();
  return strips;
}

const std::vector<FeCycle>& fe_cycles() {
  static const std::vector<FeCycle> cycles = read_fe_cycles();
  return cycles;
}

}  // namespace bumpfoil
