#include "bumpfoil/experiments/properties/properties_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "case/case_json.hpp"
#include "core/number_text.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// One number of the report: for readers in `unit`, which is `scale` in SI; for programs in SI under `key`.
struct Entry {
  std::string_view key;
  std::string_view name;
  std::string_view unit;
  double scale;
  std::optional<double> value;
  std::string_view remark{};
};

struct Group {
  std::string_view key;
  std::string_view name;
  std::vector<Entry> entries;
};

Entry stiffness_entry(std::string_view key, std::string_view name, std::optional<double> value,
                      std::string_view remark = {}) {
  return {key, name, "MN/m", 1e6, value, remark};
}

Entry length_entry(std::string_view key, std::string_view name, double value) {
  return {key, name, "mm", 1e-3, value};
}

Entry angle_entry(std::string_view key, std::string_view name, double value, std::string_view remark = {}) {
  return {key, name, "deg", std::numbers::pi / 180.0, value, remark};
}

std::string_view origin(const std::optional<double>& given) {
  return given ? "given" : "identified";
}

Entry spring_entry(std::string_view key, std::string_view name, const std::optional<double>& given, double identified) {
  const bool none = !given && identified < 0.0;
  return stiffness_entry(key, name, given.value_or(identified),
                         none ? "identified; no spring is negative: use the frame" : origin(given));
}

Group range_group(std::string_view key, std::string_view name, const std::optional<StiffnessRange>& range) {
  const auto end = [&range](double StiffnessRange::*member) {
    return range ? std::optional((*range).*member) : std::nullopt;
  };
  return {key,
          name,
          {{"softest_N_per_m", "softest mode", "N/m", 1.0, end(&StiffnessRange::softest)},
           stiffness_entry("stiffest_N_per_m", "stiffest mode", end(&StiffnessRange::stiffest))}};
}

/// Groups for bumps of one shape.
std::vector<Group> groups_of_bump(const TrussOverrides& given, const BumpProperties& p) {
  return {
      {"arc",
       "Arc of a bump, mid-surface",
       {length_entry("rise_m", "rise", p.arc.rise), length_entry("radius_m", "radius", p.arc.radius),
        angle_entry("half_angle_rad", "half angle", p.arc.half_angle),
        length_entry("flat_m", "flat between bumps", p.arc.flat)}},
      {"truss",
       "Truss constants",
       {spring_entry("k1_N_per_m", "k1, rods", given.k1, p.identified.k1),
        spring_entry("k2_N_per_m", "k2, foot to foot", given.k2, p.identified.k2),
        spring_entry("k3_N_per_m", "k3, crest to crest", given.k3, p.identified.k3),
        spring_entry("k4_N_per_m", "k4, weld to crest", given.k4, p.identified.k4),
        angle_entry("theta_d_rad", "theta_d, inclination of rods", given.theta_d.value_or(p.identified.theta_d),
                    origin(given.theta_d))}},
      {"cell",
       "Symmetric cell of the frame, energy a v^2/2 - b v e + d e^2/2",
       {stiffness_entry("a_N_per_m", "a", p.cell.a), stiffness_entry("b_N_per_m", "b", p.cell.b),
        stiffness_entry("d_N_per_m", "d", p.cell.d),
        stiffness_entry("crest_stiffness_N_per_m", "crest, feet free to slide", p.cell.crest_stiffness())}},
      {"single_bump",
       "One isolated bump, bending only",
       {stiffness_entry("shallow_N_per_m", "shallow limit", p.shallow_bump),
        stiffness_entry("sliding_N_per_m", "feet slide freely", p.sliding_bump),
        stiffness_entry("loading_N_per_m", "with friction, loading", p.loading_bump),
        stiffness_entry("unloading_N_per_m", "with friction, unloading", p.unloading_bump),
        stiffness_entry("guided_N_per_m", "rotation of feet clamped", p.guided_bump)}},
  };
}

Group bump_foil_group(const std::optional<StiffnessRange>& range) {
  return range_group("bump_foil", "Bump foil, free", range);
}

std::vector<Group> groups_of_foils(const PadDesign& pad, const Properties& p) {
  std::vector<Group> groups{range_group("top_foil", "Top foil, free", p.top_foil), bump_foil_group(p.bump_foil)};
  if (!p.assembly) return groups;
  const PadAssembly& assembly = *p.assembly;
  groups.push_back(
      {"assembly",
       "Top foil as assembled, without a journal",
       {length_entry("formed_radius_m", "formed radius", formed_radius(pad.top_foil.formed_radius, pad.bearing)),
        {"hold_down_N", "load of the last bump", "N", 1.0, assembly.hold_down},
        {"lifted_bumps", "bumps before it not loaded", "", 1.0, static_cast<double>(assembly.lifted)},
        {"bulge_m", "largest bulge over a crest", "um", 1e-6, assembly.bulge},
        angle_entry("bulge_theta_rad", "  at, from the weld", assembly.bulge_theta),
        {"clearance_less_bulge_m", "clearance less bulge", "um", 1e-6,
         pad.bearing.radial_clearance - assembly.bulge}}});
  return groups;
}

std::string text_of(const std::vector<Group>& groups) {
  std::string out;
  for (const Group& group : groups) {
    out += fmt::format("{}{}\n", out.empty() ? "" : "\n", group.name);
    for (const Entry& entry : group.entries) {
      const std::string line = fmt::format("  {:<30}{:>12} {:<6}{}", entry.name, number_text(entry.value, entry.scale),
                                           entry.unit, entry.remark);
      out += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
  }
  return out;
}

Json json_of(const std::vector<Group>& groups) {
  Json json;
  for (const Group& group : groups) {
    for (const Entry& entry : group.entries) {
      json[std::string(group.key)][std::string(entry.key)] =
          entry.value && std::isfinite(*entry.value) ? Json(*entry.value) : Json();
    }
  }
  return json;
}

/// One line per bump shape.
std::string table_of_shapes(const TrussOverrides& given, const std::vector<BumpProperties>& shapes) {
  std::string out =
      fmt::format("{:<11}{:>9}{:>9}{:>9}{:>10}{:>11}{:>11}{:>11}{:>11}{:>9}{:>11}{:>11}\n", "Bumps", "pitch", "rise",
                  "flat", "thickness", "k1", "k2", "k3", "k4", "theta_d", "row", "alone");
  out += fmt::format("{:<11}{:>9}{:>9}{:>9}{:>10}{:>11}{:>11}{:>11}{:>11}{:>9}{:>11}{:>11}\n", "", "mm", "mm", "mm",
                     "mm", "MN/m", "MN/m", "MN/m", "MN/m", "deg", "MN/m", "MN/m");
  for (const BumpProperties& p : shapes) {
    const std::string bumps = p.from == p.to ? std::to_string(p.from) : fmt::format("{} to {}", p.from, p.to);
    out += fmt::format("{:<11}{:>9}{:>9}{:>9}{:>10}{:>11}{:>11}{:>11}{:>11}{:>9}{:>11}{:>11}\n", bumps,
                       number_text(p.shape.pitch, 1e-3), number_text(p.shape.rise, 1e-3), number_text(p.arc.flat, 1e-3),
                       number_text(p.shape.thickness, 1e-3), number_text(given.k1.value_or(p.identified.k1), 1e6),
                       number_text(given.k2.value_or(p.identified.k2), 1e6),
                       number_text(given.k3.value_or(p.identified.k3), 1e6),
                       number_text(given.k4.value_or(p.identified.k4), 1e6),
                       number_text(given.theta_d.value_or(p.identified.theta_d), std::numbers::pi / 180.0),
                       number_text(p.cell.crest_stiffness(), 1e6), number_text(p.sliding_bump, 1e6));
  }
  return out +
         "k1 to theta_d: constants of the truss for a row of such bumps; where one is negative no truss exists,\n"
         "use the frame for such bumps; row: crest of the frame of such a row, feet free to slide; alone: one isolated "
         "bump,\n"
         "feet free to slide\n"
         "\n";
}

/// Bumps, and what follows them.
std::string text_of(const TrussOverrides& given, const std::vector<BumpProperties>& shapes, std::vector<Group> foils) {
  if (shapes.size() > 1) return table_of_shapes(given, shapes) + text_of(foils);
  std::vector<Group> groups = groups_of_bump(given, shapes.front());
  for (Group& group : foils) groups.push_back(std::move(group));
  return text_of(groups);
}

Json json_of(const TrussOverrides& given, const std::vector<BumpProperties>& shapes, const std::vector<Group>& foils) {
  const bool alike = shapes.size() == 1;
  Json json = alike ? json_of(groups_of_bump(given, shapes.front())) : Json();
  if (!alike) {
    for (const BumpProperties& shape : shapes) {
      Json bumps{{"from", shape.from}, {"to", shape.to}};
      bumps.update(json_of(groups_of_bump(given, shape)));
      json["bumps"].push_back(std::move(bumps));
    }
  }
  json.update(json_of(foils));
  return json;
}

}  // namespace

std::string properties_table(const PadDesign& pad, const Properties& properties) {
  const TrussOverrides& given = pad.bump_foil.truss;
  std::string out = text_of(given, properties.bumps, groups_of_foils(pad, properties));
  for (const StripProperties& strip : properties.strips) {
    out +=
        fmt::format("\nStrip {}, with bumps of its own, {} mm wide\n\n", strip.strip, number_text(strip.width, 1e-3));
    out += text_of(given, strip.bumps, {bump_foil_group(strip.bump_foil)});
  }
  return out;
}

std::string properties_json(const PadDesign& pad, const Properties& properties) {
  const TrussOverrides& given = pad.bump_foil.truss;
  Json json = json_of(given, properties.bumps, groups_of_foils(pad, properties));
  for (const StripProperties& strip : properties.strips) {
    Json own{{"strip", strip.strip}, {"width_m", strip.width}};
    own.update(json_of(given, strip.bumps, {bump_foil_group(strip.bump_foil)}));
    json["strips"].push_back(std::move(own));
  }
  return dump_json(json, 2) + '\n';
}

}  // namespace bumpfoil
