#include "bumpfoil/io/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "bumpfoil/core/version.hpp"
#include "bumpfoil/io/checksum.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "io/case_json.hpp"
#include "io/result_columns.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json value(const std::optional<double>& number) {
  return number && std::isfinite(*number) ? Json(*number) : Json();
}

Json value(const Vector& numbers) {
  return std::vector<double>(numbers.begin(), numbers.end());
}

/// Where and when the largest stress acts.
Json peak_json(const std::optional<StressPeak>& peak) {
  if (!peak) return {};
  return {{"place", name_of(peak->place)},
          {"bump", peak->bump >= 0 ? Json(peak->bump + 1) : Json()},
          {"increment", peak->increment},
          {"displacement_m", peak->displacement}};
}

Json cycle_json(const Case& input, Experiment experiment, std::size_t number, const Cycle& cycle) {
  const auto loads = [&cycle](InterfaceFields Increment::*interface) {
    if (!cycle.turning_point) return Json();
    const Vector& normal_force = (cycle.at_turning_point().*interface).normal_force;
    return normal_force.size() > 0 ? value(normal_force) : Json();
  };
  Json json;
  if (experiment == Experiment::strip) {
    json["cycle"] = number;
  } else {
    json["direction_deg"] = to_degrees(cycle.direction);
  }
  json["amplitude_m"] = cycle.amplitude;
  json["steps"] = cycle.steps;
  json["converged"] = cycle.converged;
  for (const CycleColumn& column : cycle_columns(experiment)) {
    json[name_with_unit(column.name, column.unit)] = value(column.value(cycle));
  }
  for (const StressedFoil& foil : stressed_foils()) {
    const std::optional<bool> above = above_yield(foil, input, cycle);
    json[fmt::format("max_stress_{}_at", foil.name)] = peak_json(cycle.*foil.peak);
    json[fmt::format("above_yield_{}", foil.name)] = above ? Json(*above) : Json();
  }
  json["bump_loads_N"] = loads(&Increment::top_bump);
  json["foot_loads_N"] = loads(&Increment::bump_sleeve);
  json["journal_loads_N"] = loads(&Increment::journal_top);
  json["iterations"] = cycle.total().iterations;
  json["factorisations"] = cycle.total().factorisations;
  json["substeps"] = cycle.substeps();
  return json;
}

Json files_json(const Manifest& manifest) {
  Json json = Json::object();
  for (const FileChecksum& file : manifest.files) {
    json[file.name] = {{"bytes", file.bytes}, {"xxh3_128", file.xxh3_128}};
  }
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

std::string summary_json(const Case& input, const CycleResult& result, RunStatus status, const Manifest& manifest) {
  Json json;
  json["schema"] = "bumpfoil-summary/1";
  // Before all texts of users, which could hold the same.
  json["xxh3_128"] = blank_checksum;
  json["command"] = name_of(result.experiment);
  json["case"] = case_json(input);
  json["version"] = version();
  json["commit"] = commit();
  json["solver"] = name_of(result.solver);
  json["status"] = name_of(status);
  json["run_id"] = manifest.run_id;
  json["files"] = files_json(manifest);
  json["cycles"] = Json::array();
  for (const Cycle& cycle : result.cycles) {
    json["cycles"].push_back(cycle_json(input, result.experiment, json["cycles"].size() + 1, cycle));
  }
  return sealed(dump_json(json, 2) + '\n');
}

}  // namespace bumpfoil
