#include "bumpfoil/io/case_reader.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <numbers>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/structure/identification.hpp"
#include "io/case_names.hpp"
#include "io/height_errors_csv.hpp"
#include "io/table_reader.hpp"
#include "io/text_file.hpp"
#include "io/toml_document.hpp"

namespace bumpfoil {
namespace {

using enum Presence;

const std::map<std::string, double, std::less<>> axis_directions{
    {"+X", 0.0}, {"+Y", 0.5 * std::numbers::pi}, {"-X", std::numbers::pi}, {"-Y", 1.5 * std::numbers::pi}};

/// Reads the table, or reports that it is missing as a whole.
bool open_required(ReadingLog& log, const TableReader& table, const std::string& name) {
  if (table.missing()) log.fault(name, "this table is missing", fmt::format("add [{}] with its keys", name));
  return table.present();
}

void read_bearing(ReadingLog& log, TableReader table, Bearing& bearing) {
  if (!open_required(log, table, "bearing")) return;
  table.quantity("radius", bearing.radius, Dimension::length, required);
  table.quantity("axial_length", bearing.axial_length, Dimension::length, required);
  table.quantity("radial_clearance", bearing.radial_clearance, Dimension::length, required);
  table.quantity("weld_angle", bearing.weld_angle, Dimension::angle, optional);
  table.choice("wrap", bearing.wrap, wrap_names);
  table.finish();
}

void read_truss(TableReader table, TrussOverrides& truss) {
  table.quantity("k1", truss.k1, Dimension::stiffness);
  table.quantity("k2", truss.k2, Dimension::stiffness);
  table.quantity("k3", truss.k3, Dimension::stiffness);
  table.quantity("k4", truss.k4, Dimension::stiffness);
  table.quantity("theta_d", truss.theta_d, Dimension::angle);
  table.finish();
}

/// Height errors from the list or from the file, which is looked for beside the case file.
void read_height_errors_of(ReadingLog& log, TableReader& table, BumpFoil& foil) {
  std::string csv;
  table.quantities("height_errors", foil.height_errors, Dimension::length, optional);
  if (!table.text("height_errors_file", csv)) return;
  if (csv.empty()) {
    log.fault(table.path_of("height_errors_file"), "is empty", "give the name of a CSV file, or leave it out");
    return;
  }
  if (!foil.height_errors.empty()) {
    log.fault(table.path_of("height_errors_file"), "contradicts height_errors, which is given too",
              "give one of the two");
    return;
  }
  if (foil.bumps < 1 || foil.bumps > most_bumps) return;  // reported as such
  try {
    const std::filesystem::path folder = std::filesystem::path(log.file()).parent_path();
    foil.height_errors = read_height_errors((folder / csv).string(), foil.bumps);
  } catch (const Error& error) {
    for (const Fault& fault : error.faults()) log.add(fault, error.kind());
  }
}

void read_bump_foil(ReadingLog& log, TableReader table, BumpFoil& foil) {
  if (!open_required(log, table, "bump_foil")) return;
  table.choice("model", foil.model, model_names);
  table.choice("geometry", foil.geometry, geometry_names);
  table.integer("bumps", foil.bumps, required);
  table.quantity("pitch", foil.pitch, Dimension::length, required);
  table.quantity("length", foil.length, Dimension::length, required);
  table.quantity("height", foil.height, Dimension::length, required);
  table.choice("height_reference", foil.height_reference, height_reference_names);
  table.quantity("thickness", foil.thickness, Dimension::length, required);
  table.quantity("youngs_modulus", foil.youngs_modulus, Dimension::pressure, required);
  table.number("poisson_ratio", foil.poisson_ratio, required);
  table.quantity("yield_stress", foil.yield_stress, Dimension::pressure);
  read_height_errors_of(log, table, foil);
  table.flag("stiffness_follows_height", foil.stiffness_follows_height);
  table.quantities("sleeve_gaps", foil.sleeve_gaps, Dimension::length, optional);
  table.choice("weld_at", foil.weld_at, weld_position_names);
  read_truss(table.table("truss"), foil.truss);
  table.finish();
}

/// The material defaults to that of the bump foil; the former model needs no top foil at all.
void read_top_foil(ReadingLog& log, TableReader table, const BumpFoil& bump_foil, TopFoil& foil) {
  if (table.missing() && bump_foil.model == BumpFoilModel::former) return;
  if (!open_required(log, table, "top_foil")) return;
  foil.youngs_modulus = bump_foil.youngs_modulus;
  foil.poisson_ratio = bump_foil.poisson_ratio;
  foil.yield_stress = bump_foil.yield_stress;
  for (const std::string key : {"youngs_modulus", "poisson_ratio", "yield_stress"}) {
    if (!table.has(key)) log.taken_from("top_foil." + key, "bump_foil." + key);
  }
  table.quantity("thickness", foil.thickness, Dimension::length, required);
  table.quantity("youngs_modulus", foil.youngs_modulus, Dimension::pressure, optional);
  table.number("poisson_ratio", foil.poisson_ratio, optional);
  table.quantity("yield_stress", foil.yield_stress, Dimension::pressure);
  table.finish();
}

/// One coefficient for both interfaces, or one for each.
void read_friction(ReadingLog& log, TableReader table, Friction& friction) {
  if (table.missing()) {
    log.fault("friction", "this table is missing", "add [friction] with coefficient = 0.1, or 0 for none");
  }
  if (!table.present()) return;
  const bool common = table.has("coefficient");
  if (common) {
    log.taken_from("friction.top_bump", "friction.coefficient");
    log.taken_from("friction.bump_sleeve", "friction.coefficient");
  }
  if (!common && !table.has("top_bump") && !table.has("bump_sleeve")) {
    log.fault("friction.coefficient", "is missing", "give it, 0 for none, or both top_bump and bump_sleeve");
  }
  table.number("coefficient", friction.top_bump, optional);
  friction.bump_sleeve = friction.top_bump;
  const Presence each = !common && (table.has("top_bump") || table.has("bump_sleeve")) ? required : optional;
  table.number("top_bump", friction.top_bump, each);
  table.number("bump_sleeve", friction.bump_sleeve, each);
  if (common && (table.has("top_bump") || table.has("bump_sleeve"))) {
    log.fault("friction.coefficient", "contradicts top_bump or bump_sleeve, which are given too",
              "give either the coefficient or both of the others");
  }
  table.finish();
}

void read_solver(TableReader table, SolverSettings& solver) {
  table.choice("name", solver.name, solver_names);
  table.quantity("eps_alm", solver.uzawa.eps_alm, Dimension::stiffness, optional);
  table.quantity("eps_f", solver.uzawa.eps_f, Dimension::stiffness, optional);
  table.quantity("eps_r", solver.uzawa.eps_r, Dimension::stiffness, optional);
  table.quantity("tau_f", solver.uzawa.tau_f, Dimension::length, optional);
  table.finish();
}

void read_cycle(ReadingLog& log, TableReader table, CycleSettings& cycle) {
  if (!table.present()) return;
  table.quantities("directions", cycle.directions, Dimension::angle, required, axis_directions);
  table.quantity("amplitude", cycle.amplitude, Dimension::length, required);
  table.integer("steps", cycle.steps, optional);
  table.finish();
  // A case without directions and amplitude would pass for one without the table.
  if (cycle.directions.empty() && cycle.amplitude == 0.0) {
    log.later_fault(
        {"", 0, "cycle.directions", "", "there is no direction to push in", "give a list such as [\"+X\"]"});
    log.later_fault({"", 0, "cycle.amplitude", "", "must be positive", "give a length such as \"79.5 um\""});
  }
}

/// A key that holds a length or a force; plain numbers are as `target` was.
void read_target(TableReader& table, std::string_view key, PlateTarget& target) {
  Dimension dimension = target.control == PlateControl::load ? Dimension::force : Dimension::length;
  table.quantity(key, target.value, dimension, Dimension::length, Dimension::force);
  target.control = dimension == Dimension::force ? PlateControl::load : PlateControl::displacement;
}

void read_strip(ReadingLog& log, TableReader table, int bumps, std::optional<StripSettings>& settings) {
  if (!table.present()) return;
  StripSettings strip;
  strip.bumps = bumps;
  table.integer("bumps", strip.bumps, optional);
  if (!table.has("bumps")) log.taken_from("strip.bumps", "bump_foil.bumps");
  table.choice("weld", strip.weld, strip_weld_names);
  table.flag("top_foil", strip.top_foil);
  const bool by_load = table.has("load");
  double displacement = 0.0;
  double load = 0.0;
  table.quantity("displacement", displacement, Dimension::length, by_load ? optional : required);
  table.quantity("load", load, Dimension::force, optional);
  if (by_load && table.has("displacement")) {
    log.fault("strip.displacement", "contradicts load, which is given too", "give one of the two");
  }
  strip.amplitude = {by_load ? PlateControl::load : PlateControl::displacement, by_load ? load : displacement};
  PlateTarget preload{strip.amplitude.control, 0.0};
  read_target(table, "preload", preload);
  if (table.has("preload")) strip.preload = preload;
  table.integer("cycles", strip.cycles, optional);
  table.integer("steps", strip.steps, optional);
  table.finish();
  settings = strip;
}

}  // namespace

Case parse_case(std::string_view text, const std::string& name, const CaseRequest& request) {
  toml::table document = parse_toml(text, name);
  ReadingLog log(name);
  for (Fault& fault : apply_overrides(document, request.overrides)) log.add(std::move(fault));
  TableReader root(log, &document, "");
  Case input;
  root.text("title", input.title);
  read_bearing(log, root.table("bearing"), input.bearing);
  read_bump_foil(log, root.table("bump_foil"), input.bump_foil);
  read_top_foil(log, root.table("top_foil"), input.bump_foil, input.top_foil);
  read_friction(log, root.table("friction"), input.friction);
  read_solver(root.table("solver"), input.solver);
  read_cycle(log, root.table("cycle"), input.cycle);
  read_strip(log, root.table("strip"), input.bump_foil.bumps, input.strip);
  root.finish();
  for (const std::string& table : request.required_tables) {
    if (!root.has(table))
      log.fault(table, "this table is missing", fmt::format("add [{}]: this command needs it", table));
  }
  std::vector<Fault> faults = find_faults(input);
  if (faults.empty() && input.bump_foil.model != BumpFoilModel::frame)
    faults = find_truss_faults(make_bearing_foils(input));
  for (const Fault& fault : faults) log.later_fault(fault);
  log.throw_if_faulty();
  return input;
}

Case read_case(const std::string& path, const CaseRequest& request) {
  return parse_case(read_case_text(path), path, request);
}

std::string read_case_text(const std::string& path) {
  std::string text = read_text_file(path);
  if (is_blank(text)) {
    throw Error(ErrorKind::input, {{path, 0, "", "", "is empty", "`bumpfoil init` writes a case file to start from"}});
  }
  return text;
}

}  // namespace bumpfoil
