#include "bumpfoil/io/case_writer.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "bumpfoil/core/printable.hpp"
#include "io/case_json.hpp"
#include "io/case_names.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Units of the keys that have one, for comments.
const std::map<std::string, std::string_view, std::less<>> units{
    {"radius", "m"},
    {"axial_length", "m"},
    {"radial_clearance", "m"},
    {"weld_angle", "rad"},
    {"pitch", "m"},
    {"length", "m"},
    {"height", "m"},
    {"thickness", "m"},
    {"height_errors", "m"},
    {"youngs_modulus", "Pa"},
    {"yield_stress", "Pa"},
    {"sleeve_gaps", "m"},
    {"k1", "N/m"},
    {"k2", "N/m"},
    {"k3", "N/m"},
    {"k4", "N/m"},
    {"theta_d", "rad"},
    {"eps_alm", "N/m"},
    {"eps_f", "N/m"},
    {"eps_r", "N/m"},
    {"tau_f", "m"},
    {"directions", "rad"},
    {"amplitude", "m"},
    {"displacement", "m"},
    {"load", "N"},
};

void append_table(std::string& out, const std::string& path, const Json& table) {
  if (!path.empty()) out += fmt::format("\n[{}]\n", path);
  for (const auto& [key, value] : table.items()) {
    if (value.is_object()) continue;
    const auto unit = units.find(key);
    // JSON texts are TOML texts, too, as the delete character is escaped.
    out += fmt::format("{} = {}{}\n", key, dump_json(value, -1),
                       unit != units.end() ? fmt::format("  # {}", unit->second) : std::string());
  }
  for (const auto& [key, value] : table.items()) {
    if (value.is_object()) append_table(out, path.empty() ? key : path + "." + key, value);
  }
}

Json bump_foil_json(const BumpFoil& foil) {
  Json json{{"model", name_in(model_names, foil.model)},
            {"geometry", name_in(geometry_names, foil.geometry)},
            {"bumps", foil.bumps},
            {"pitch", foil.pitch},
            {"length", foil.length},
            {"height", foil.height},
            {"height_reference", name_in(height_reference_names, foil.height_reference)},
            {"thickness", foil.thickness},
            {"youngs_modulus", foil.youngs_modulus},
            {"poisson_ratio", foil.poisson_ratio}};
  if (foil.yield_stress) json["yield_stress"] = *foil.yield_stress;
  if (!foil.height_errors.empty()) json["height_errors"] = foil.height_errors;
  if (!foil.sleeve_gaps.empty()) json["sleeve_gaps"] = foil.sleeve_gaps;
  json["stiffness_follows_height"] = foil.stiffness_follows_height;
  json["weld_at"] = name_in(weld_position_names, foil.weld_at);
  Json truss;
  const auto add = [&truss](const char* key, const std::optional<double>& value) {
    if (value) truss[key] = *value;
  };
  add("k1", foil.truss.k1);
  add("k2", foil.truss.k2);
  add("k3", foil.truss.k3);
  add("k4", foil.truss.k4);
  add("theta_d", foil.truss.theta_d);
  if (!truss.empty()) json["truss"] = truss;
  return json;
}

/// A preload that is not of the kind of a plain number there carries its unit.
Json target_json(const PlateTarget& target, PlateControl plain) {
  if (target.control == plain) return target.value;
  return fmt::format("{:.17g} {}", target.value, target.control == PlateControl::load ? "N" : "m");
}

Json strip_json(const StripSettings& strip) {
  const bool by_load = strip.amplitude.control == PlateControl::load;
  Json json{{"bumps", strip.bumps},
            {"weld", name_in(strip_weld_names, strip.weld)},
            {"top_foil", strip.top_foil},
            {by_load ? "load" : "displacement", strip.amplitude.value}};
  if (strip.preload) json["preload"] = target_json(*strip.preload, strip.amplitude.control);
  json["cycles"] = strip.cycles;
  json["steps"] = strip.steps;
  return json;
}

}  // namespace

nlohmann::ordered_json case_json(const Case& input) {
  Json json;
  json["title"] = input.title;
  json["bearing"] = {{"radius", input.bearing.radius},
                     {"axial_length", input.bearing.axial_length},
                     {"radial_clearance", input.bearing.radial_clearance},
                     {"weld_angle", input.bearing.weld_angle},
                     {"wrap", name_in(wrap_names, input.bearing.wrap)}};
  json["bump_foil"] = bump_foil_json(input.bump_foil);
  if (input.top_foil != TopFoil{}) {  // the former model has none
    json["top_foil"] = {{"thickness", input.top_foil.thickness},
                        {"youngs_modulus", input.top_foil.youngs_modulus},
                        {"poisson_ratio", input.top_foil.poisson_ratio}};
    if (input.top_foil.yield_stress) json["top_foil"]["yield_stress"] = *input.top_foil.yield_stress;
  }
  json["friction"] = {{"top_bump", input.friction.top_bump}, {"bump_sleeve", input.friction.bump_sleeve}};
  const UzawaParameters& uzawa = input.solver.uzawa;
  json["solver"] = {{"name", name_in(solver_names, input.solver.name)},
                    {"eps_alm", uzawa.eps_alm},
                    {"eps_f", uzawa.eps_f},
                    {"eps_r", uzawa.eps_r},
                    {"tau_f", uzawa.tau_f}};
  if (!input.cycle.directions.empty()) {
    json["cycle"] = {
        {"directions", input.cycle.directions}, {"amplitude", input.cycle.amplitude}, {"steps", input.cycle.steps}};
  }
  if (input.strip) json["strip"] = strip_json(*input.strip);
  return json;
}

std::string dump_json(const nlohmann::ordered_json& json, int indent) {
  return printable_json(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

std::string_view name_of(SolverName solver) {
  return name_in(solver_names, solver);
}

std::string case_to_toml(const Case& input) {
  std::string out;
  append_table(out, "", case_json(input));
  return out;
}

std::string case_to_json(const Case& input) {
  return dump_json(case_json(input), 2) + '\n';
}

}  // namespace bumpfoil
