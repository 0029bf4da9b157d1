#include "experiments/cycle/cycle_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bumpfoil/core/angle.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Location and increment of the maximum stress.
Json peak_json(const Case& input, const std::optional<StressPeak>& peak) {
  if (!peak) return {};
  Json json{{"place", name_of(peak->place)}, {"bump", peak->bump >= 0 ? Json(peak->bump + 1) : Json()}};
  if (const auto pad = pad_of(input, *peak)) json["pad"] = *pad + 1;
  json["increment"] = peak->increment;
  json["displacement_m"] = peak->displacement;
  return json;
}

void add_loads(Json& json, const Case& input, Experiment experiment, const Cycle& cycle) {
  for (const LoadQuantity& quantity : load_quantities(experiment)) {
    if (quantity.node == Node::pad && count_pads(input) == 1) continue;
    if (quantity.node == Node::strip && strips_apart(input) == 1) continue;
    Json& values = json[quantity.key()];
    for (const double load : quantity.value(cycle)) values.push_back(value_json(load));
  }
}

}  // namespace

Json cycle_json(const Case& input, const CycleResult& result, std::size_t i) {
  const Cycle& cycle = result.cycles[i];
  Json json;
  const std::string key(cycle_key(result.experiment));
  if (result.experiment == Experiment::strip) json[key] = i + 1;
  if (result.experiment == Experiment::cycle) json[key] = to_degrees(cycle.direction);
  json.update(values_json(cycle_quantities(result.experiment, result.over_width), cycle, input));
  if (result.experiment == Experiment::path) {
    json["orbits"] = Json::array();
    for (const OrbitLoop& orbit : cycle.orbits) {
      json["orbits"].push_back({{"energy_J", orbit.energy},
                                {"force_defect_N", orbit.force_defect},
                                {"position_defect_m", orbit.position_defect}});
    }
  }
  if (result.experiment == Experiment::cycle) {
    const std::vector<VariableMeaning> clearances =
        clearance_quantities(input.settings.get<CycleSettings>().clearance_forces);
    for (std::size_t k = 0; k < clearances.size(); ++k) {
      json[clearances[k].key()] = value_json(clearance_of(cycle, k));
    }
  }
  json["clearances"] = Json::array();
  for (const Clearance& clearance : cycle.clearances) {
    json["clearances"].push_back({{"force_N", clearance.force},
                                  {"displacement_m", clearance.displacement ? Json(*clearance.displacement) : Json()}});
  }
  json["loop_energies_J"] = cycle.loop_energies;
  json["warnings"] = warnings_of(input, result, i);
  const std::optional<Failure> failure = failure_of(input, result, i);
  const bool located = failure && failure->increment;
  json["failed_increment"] = located ? Json(*failure->increment) : Json();
  json["failed_displacement_m"] = located ? value_json(failure->displacement) : Json();
  json["reason"] = failure ? Json(failure->reason) : Json();
  for (const StressedFoil& foil : stressed_foils()) {
    json[fmt::format("max_stress_{}_at", foil.name)] = peak_json(input, cycle.*foil.peak);
  }
  return json;
}

Json cycle_lists(const Case& input, const CycleResult& result) {
  Json json{{"cycles", Json::array()}};
  for (std::size_t i = 0; i < result.cycles.size(); ++i) {
    json["cycles"].push_back(cycle_json(input, result, i));
    add_loads(json["cycles"].back(), input, result.experiment, result.cycles[i]);
  }
  return json;
}

}  // namespace bumpfoil
