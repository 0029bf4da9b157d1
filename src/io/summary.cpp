#include "bumpfoil/io/summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "bumpfoil/core/version.hpp"
#include "io/case_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json value(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? Json(*number) : Json();
}

Json value(const Vector& numbers) {
  return std::vector<double>(numbers.begin(), numbers.end());
}

Json cycle_json(const Cycle& cycle) {
  const Increment* initial = cycle.increments.empty() ? nullptr : &cycle.increments.front();
  const auto at_start = [initial](double Increment::*member) { return initial ? value(initial->*member) : Json(); };
  const auto at_turn = [&cycle](double TurningPoint::*member) {
    return cycle.turning_point ? value((*cycle.turning_point).*member) : Json();
  };
  const auto loads = [&cycle](InterfaceFields Increment::*interface) {
    return cycle.turning_point ? value((cycle.at_turning_point().*interface).normal_force) : Json();
  };
  Json json;
  json["direction_deg"] = to_degrees(cycle.direction);
  json["amplitude_m"] = cycle.amplitude;
  json["steps"] = cycle.steps;
  json["converged"] = cycle.converged;
  json["max_force_N"] = at_turn(&TurningPoint::max_force);
  json["cross_force_at_max_N"] = at_turn(&TurningPoint::cross_force);
  json["initial_force_N"] = at_start(&Increment::force_direct);
  json["initial_force_x_N"] = at_start(&Increment::force_x);
  json["initial_force_y_N"] = at_start(&Increment::force_y);
  json["initial_journal_load_N"] = initial ? value(cycle.initial_journal_load()) : Json();
  json["initial_elastic_energy_J"] = at_start(&Increment::elastic_energy);
  json["assembly_dissipation_J"] = initial ? value(cycle.assembly_dissipation) : Json();
  json["loop_energy_J"] = value(cycle.loop_energy);
  json["elastic_energy_at_max_J"] = at_turn(&TurningPoint::elastic_energy);
  json["loss_factor"] = value(cycle.loss_factor);
  json["tangent_stiffness_loading_N_per_m"] = at_turn(&TurningPoint::tangent_stiffness_loading);
  json["tangent_stiffness_unloading_N_per_m"] = at_turn(&TurningPoint::tangent_stiffness_unloading);
  json["secant_stiffness_N_per_m"] = at_turn(&TurningPoint::secant_stiffness);
  json["first_contact_m"] = value(cycle.first_contact);
  json["clearance_5N_m"] = value(cycle.clearance_5N);
  json["clearance_10N_m"] = value(cycle.clearance_10N);
  json["bump_loads_N"] = loads(&Increment::top_bump);
  json["foot_loads_N"] = loads(&Increment::bump_sleeve);
  json["journal_loads_N"] = loads(&Increment::journal_top);
  json["max_residual"] = value(cycle.max_residual());
  json["iterations"] = cycle.total().iterations;
  json["substeps"] = cycle.substeps();
  json["wall_time_s"] = cycle.wall_time;
  return json;
}

}  // namespace

std::string_view name_of(RunStatus status) {
  switch (status) {
    case RunStatus::complete:
      return "complete";
    case RunStatus::failed:
      return "failed";
    case RunStatus::interrupted:
      return "interrupted";
  }
  return "";
}

double to_degrees(double angle) {
  const double degrees = angle * (180.0 / std::numbers::pi);
  const double whole = std::round(degrees);
  return std::abs(degrees - whole) < 1e-12 * (1.0 + std::abs(whole)) ? whole : degrees;
}

std::string summary_json(const Case& input, const CycleResult& result, RunStatus status) {
  Json json;
  json["schema"] = "bumpfoil-summary/1";
  json["case"] = case_json(input);
  json["version"] = version();
  json["commit"] = commit();
  json["solver"] = result.solver;
  json["status"] = name_of(status);
  json["cycles"] = Json::array();
  for (const Cycle& cycle : result.cycles) json["cycles"].push_back(cycle_json(cycle));
  return dump_json(json, 2) + '\n';
}

}  // namespace bumpfoil
