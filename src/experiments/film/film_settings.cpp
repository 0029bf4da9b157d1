#include <algorithm>
#include <cmath>
#include <string_view>

#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "case/case_keys.hpp"
#include "experiments/film/film_keys.hpp"
#include "model/case_table.hpp"

namespace bumpfoil {
namespace {

void describe(CaseVisitor& keys, GasSettings& gas) {
  using enum Presence;
  using enum Dimension;
  keys.choice({"preset", defaulted, "Gas", "sets the viscosity; or \"helium\", \"nitrogen\", \"steam\""}, gas.preset);
  keys.value({"temperature", defaulted, "Temperature", "of the film, uniform", "293 K", temperature}, &gas.temperature);
  keys.value({.name = "viscosity",
              .presence = optional,
              .title = "Viscosity",
              .text = "instead of that of the preset at the temperature",
              .example = "18.5 uPa s",
              .dimension = viscosity,
              .instead = true},
             &gas.viscosity);
  keys.value({"ambient_pressure", defaulted, "Ambient pressure", "at the edges of the film and behind the foils",
              "101325 Pa", pressure},
             &gas.ambient_pressure);
  keys.value(
      {"mean_free_path", defaulted, "Mean free path", "at ambient pressure; 0: no slip at the walls", "0 nm", length},
      &gas.mean_free_path);
}

void describe(CaseVisitor& keys, FilmSettings& film) {
  using enum Presence;
  using enum Dimension;
  keys.value({"columns_per_pitch", defaulted, "Columns per pitch",
              "of the mesh; even, so that every crest is a column; with staggered strips a multiple of 6, unless all "
              "staggers are 0 or 0.5"},
             &film.columns_per_pitch);
  keys.value({"rows", defaulted, "Rows", "of the mesh, on half the width"}, &film.rows);
  keys.value({"h_floor", defaulted, "Contact threshold",
              "a thinner film of smooth surfaces counts as contact (touchdown)", "0.1 um", length},
             &film.h_floor);
  keys.value(
      {"h_lift_off", optional, "Lift-off above",
       "minimum film thickness of a journal that has lifted off, such as three times the roughness", "2 um", length},
      &film.h_lift_off);
  keys.value({"inlet_pressure", optional, "Inlet pressure",
              "of gas that is fed to the free ends of the foils; default: ambient, as behind the foils", "101.8 kPa",
              pressure},
             &film.inlet_pressure);
  keys.value({"side_pressure", optional, "Side pressure",
              "of gas at the sides z < 0 and z > 0, as of a cooling flow; default: ambient, as behind the foils",
              "[\"102 kPa\", \"101.325 kPa\"]", pressure},
             &film.side_pressure);
  keys.choice({"wall", defaulted, "Bearing surface",
               "bearing surface instead of the foils, for the command film; or \"springs\": an elastic foundation, or "
               "\"rigid_across\": an axially uniform one"},
              film.wall);
  keys.value({"wall_stiffness", optional, "Foundation modulus", "of the elastic foundation: pressure over displacement",
              "5 GPa/m", foundation_modulus},
             &film.wall_stiffness);
  keys.value({"closed", defaulted, "Closed surface", "true: no slot at the weld"}, &film.closed);
}

void describe(CaseVisitor& keys, WidthSettings& width) {
  using enum Presence;
  using enum Dimension;
  keys.value({"modes", defaulted, "Modes over the width",
              "of the displacement of the foils, for equilibrium and the commands with a rotor, and without a film for "
              "a journal that is tilted or not cylindrical: 1, uniform; 2, also linear; 3, also a parabola; 4 and 5, "
              "also polynomials of the third and fourth degree. With 2 or more bearings resist the tilt of a rotor"},
             &width.modes);
  keys.value({"sheet", defaulted, "Elastic sheet",
              "true: the feet of the bump foil slide by different amounts over the width, with 3 modes or more; false: "
              "they do not"},
             &width.sheet);
  keys.value({"tilt", defaulted, "Tilt",
              "misalignment: slope of the axis of the journal, or under a rotor of the line through the centres of its "
              "bearings, towards X and Y",
              "[\"0 mrad\", \"0 mrad\"]", angle},
             &width.tilt);
  keys.value({.name = "moment",
              .presence = optional,
              .title = "Moment",
              .text = "on the journal instead, of forces along X and Y about the mid-plane: the journal tilts until "
                      "the bearing balances it; not for film, nor under a rotor",
              .example = "[\"50 N mm\", \"0 N mm\"]",
              .dimension = moment,
              .instead = true},
             &width.moment);
  keys.value(
      {"conicity", defaulted, "Conicity",
       "clearance at the side z > 0 less that at the side z < 0, of a conical journal or sleeve", "5 um", length},
      &width.conicity);
  keys.value({"crowning", defaulted, "Crowning",
              "clearance at both sides less that in the middle, of a barrel-shaped journal or a bell-mouthed sleeve",
              "5 um", length},
             &width.crowning);
}

void describe(CaseVisitor& keys, AsperitySettings& asperity) {
  using enum Presence;
  using enum Dimension;
  keys.value({"sigma", required, "Roughness", "of journal and top foil together: root of the sum of both variances",
              "0.3 um", length},
             &asperity.sigma);
  keys.value({"friction", required, "Friction", "coefficient of peaks that rub, as of a coating", "0.2"},
             &asperity.friction);
  keys.value({.name = "pressure_factor",
              .presence = optional,
              .title = "Pressure factor",
              .text = "K' of the pressure K' F_5/2(h/sigma), instead of density, radius and modulus",
              .example = "250 MPa",
              .dimension = pressure,
              .instead = true},
             &asperity.pressure_factor);
  keys.value({"density", optional, "Peaks per area", "of both surfaces together", "17000 1/mm2", per_area},
             &asperity.density);
  keys.value({"radius", optional, "Radius of peaks", "at their tips", "10 um", length}, &asperity.radius);
  keys.value({"modulus", optional, "Contact modulus",
              "1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 of journal and top foil; default: both are of the top foil's "
              "material",
              "117 GPa", pressure},
             &asperity.modulus);
}

void describe_film(CaseVisitor& keys, Case& input) {
  using enum Presence;
  defaulted_table(keys, {"gas", defaulted, "Gas", "between journal and top foil, for all commands with a film"},
                  input.gas, [](CaseVisitor& inner, GasSettings& gas) { describe(inner, gas); });
  defaulted_table(keys, {"film", defaulted, "Film", "mesh of the film, and limits of its thickness"}, input.film,
                  [](CaseVisitor& inner, FilmSettings& film) { describe(inner, film); });
  defaulted_table(keys, {"width", defaulted, "Width", "how journal and foils vary over the width"}, input.width,
                  [](CaseVisitor& inner, WidthSettings& width) { describe(inner, width); });
  optional_table(keys,
                 {"asperity", optional, "Mixed contact",
                  "rough surfaces of journal and top foil that touch where the film is thin, for all commands with "
                  "foils on a film; none: smooth"},
                 input.asperity, [](CaseVisitor& inner, AsperitySettings& asperity) { describe(inner, asperity); });
}

constexpr Range ambient_range{1e2, 1e8, "Pa"};
constexpr Range viscosity_range{1e-7, 1e-2, "Pa s"};
constexpr Range free_path_range{0.0, 1e-4, "m"};

/// Larger film meshes are input errors.
constexpr int most_columns = 100;
constexpr int most_film_rows = 200;
/// Memory estimate of the equations. Bytes for each pair of rows: at a crest, with contacts, and in a column; fitted to
/// 26 bumps on 6 x 50 to 12 x 200, within 15 %.
constexpr double bytes_at_crest = 285.0;
constexpr double bytes_of_column = 37.0;
constexpr double most_film_bytes = 2e9;

void check_gas(Checks& checks, const GasSettings& gas) {
  const auto [least, most] = temperature_range(gas.preset);
  checks.require(gas.viscosity || (gas.temperature >= least && gas.temperature <= most), "gas.temperature",
                 quantity(gas.temperature, "K"),
                 fmt::format("the viscosity of {} is not available there", name_of(gas.preset)),
                 fmt::format("give a temperature from {} to {} K, or gas.viscosity", least, most));
  if (gas.viscosity) checks.within("gas.viscosity", *gas.viscosity, viscosity_range);
  checks.within("gas.ambient_pressure", gas.ambient_pressure, ambient_range);
  checks.within("gas.mean_free_path", gas.mean_free_path, free_path_range);
}

/// @param bumps  their number, 0 if unusable
/// @param stations  columns with crests, at each of which they are side by side in the equations
/// @param equal_halves  Case::has_equal_halves(): otherwise twice as many rows
void check_film(Checks& checks, const FilmSettings& film, int bumps, double stations, bool equal_halves) {
  const int columns = film.columns_per_pitch;
  const bool columns_right = checks.require(
      columns >= 4 && columns <= most_columns && columns % 2 == 0, "film.columns_per_pitch", std::to_string(columns),
      "does not put a column over every crest", fmt::format("give an even number from 4 to {}", most_columns));
  const bool rows_right =
      checks.require(film.rows >= 2 && film.rows <= most_film_rows, "film.rows", std::to_string(film.rows),
                     "is not a valid number of rows", fmt::format("give a whole number from 2 to {}", most_film_rows));
  if (columns_right && rows_right) {
    const int rows = equal_halves ? film.rows : 2 * film.rows;
    const double bytes = static_cast<double>(bumps) * rows * rows *
                         (stations * stations * bytes_at_crest + bytes_of_column * static_cast<double>(columns));
    checks.require_for(experiments_where(&CaseTable::film), bytes <= most_film_bytes, "film.columns_per_pitch",
                       std::to_string(columns),
                       fmt::format("makes {} columns of {} rows, which need about {:.2g} GB of memory", columns * bumps,
                                   rows, 1e-9 * bytes),
                       fmt::format("give a mesh that needs {:.2g} GB at most", 1e-9 * most_film_bytes));
  }
  if (film.wall != FilmWall::rigid) {
    checks.require(film.wall_stiffness.has_value(), "film.wall_stiffness", "",
                   "is missing, but the elastic foundation needs it",
                   "give a stiffness such as \"5 GPa/m\", or wall = \"rigid\"");
  }
  if (film.wall_stiffness) checks.within("film.wall_stiffness", *film.wall_stiffness, {1e3, 1e18, "Pa/m"});
  checks.within("film.h_floor", film.h_floor, {0.0, 1e-3, "m"});
  if (film.inlet_pressure) checks.within("film.inlet_pressure", *film.inlet_pressure, ambient_range);
  if (!film.side_pressure.empty() &&
      checks.require(film.side_pressure.size() == 2, "film.side_pressure",
                     fmt::format("{} numbers", film.side_pressure.size()), "is not a pressure at each side",
                     "give those at z < 0 and z > 0, such as [\"102 kPa\", \"101.325 kPa\"]")) {
    for (std::size_t i = 0; i < 2; ++i) {
      checks.within(fmt::format("film.side_pressure[{}]", i + 1), film.side_pressure[i], ambient_range);
    }
  }
  if (film.h_lift_off && checks.within("film.h_lift_off", *film.h_lift_off, {1e-9, 1e-3, "m"})) {
    checks.require(*film.h_lift_off > film.h_floor, "film.h_lift_off", quantity(*film.h_lift_off, "m"),
                   fmt::format("is not above film.h_floor, {:.6g} m, the contact threshold", film.h_floor),
                   "give a larger h_lift_off or a smaller h_floor");
  }
}

constexpr Range roughness_range{1e-9, 1e-4, "m"};
constexpr Range pressure_factor_range{1e3, 1e13, "Pa"};
constexpr Range density_range{1e6, 1e15, "1/m2"};
constexpr Range peak_radius_range{1e-9, 1e-2, "m"};

void check_asperity(Checks& checks, const AsperitySettings& asperity) {
  checks.within("asperity.sigma", asperity.sigma, roughness_range);
  checks.within("asperity.friction", asperity.friction, {0.0, 2.0, ""});
  if (asperity.pressure_factor)
    checks.within("asperity.pressure_factor", *asperity.pressure_factor, pressure_factor_range);
  if (asperity.density) checks.within("asperity.density", *asperity.density, density_range);
  if (asperity.radius) checks.within("asperity.radius", *asperity.radius, peak_radius_range);
  if (asperity.modulus) checks.within("asperity.modulus", *asperity.modulus, {1e6, 1e13, "Pa"});
  const bool by_peaks = asperity.density || asperity.radius || asperity.modulus;
  checks.require(!asperity.pressure_factor || !by_peaks, "asperity.pressure_factor", "",
                 "conflicts with density, radius or modulus, from which it follows",
                 "give either the factor or those three");
  if (asperity.pressure_factor) return;
  checks.require(asperity.density.has_value(), "asperity.density", "", "is missing, as is pressure_factor",
                 "give peaks per area such as \"17000 1/mm2\", or pressure_factor such as \"250 MPa\"");
  checks.require(asperity.radius.has_value(), "asperity.radius", "", "is missing, as is pressure_factor",
                 "give the radius of the peaks such as \"10 um\", or pressure_factor such as \"250 MPa\"");
}

constexpr int most_modes = 5;           // over the width
constexpr double most_slope = 0.05;     // rad
constexpr double most_moment = 1e6;     // N m
constexpr double most_widening = 1e-3;  // m

/// Checks a number of either sign.
void check_size(Checks& checks, const std::string& key, double value, double most, const char* unit) {
  if (!checks.finite(key, value, unit)) return;
  checks.require(std::abs(value) <= most, key, quantity(value, unit), "is unphysical",
                 fmt::format("give at most {} either way; is the unit right?", quantity(most, unit)));
}

/// Checks a pair of components along X and Y.
void check_pair(Checks& checks, const char* key, const std::vector<double>& pair, double most, const char* unit,
                const char* example) {
  if (!checks.require(pair.size() == 2, key, fmt::format("{} numbers", pair.size()), "is not a pair along X and Y",
                      fmt::format("give two components such as {}", example))) {
    return;
  }
  for (std::size_t i = 0; i < 2; ++i) check_size(checks, fmt::format("{}[{}]", key, i + 1), pair[i], most, unit);
}

/// Checks a journal that loads the foils unevenly over the width, without a film.
/// @param key  that causes it
void check_dry_width(Checks& checks, const Case& input, const char* key) {
  const std::vector<std::string_view> dry = experiments_where(&CaseTable::is_dry);
  checks.require_for(dry, input.width.modes != 1 || input.top_foil.split, key, "",
                     "needs foils that can follow it where there is no film",
                     "set width.modes = 3, or 2 without a parabola");
  checks.require_for(dry, input.bump_foil.geometry == Geometry::linear, key, "",
                     "is not supported with large displacements", "set bump_foil.geometry = \"linear\"");
  checks.require_for(dry, input.bump_foil.model != BumpFoilModel::former, key, "",
                     "needs a top foil, which the Le Lez (2007) model does not have",
                     "set model = \"truss\" or \"frame\"");
  checks.require_for(dry, input.width.moment.empty() || input.solver.chosen() != SolverName::uzawa, "solver.name",
                     std::string(name_of(input.solver.chosen())), "does not support a journal that is free to tilt",
                     "set name = \"newton\" or \"events\"");
}

/// Checks journals and sleeves that are tilted or not cylindrical.
void check_journal(Checks& checks, const Case& input) {
  const WidthSettings& width = input.width;
  check_size(checks, "width.conicity", width.conicity, most_widening, "m");
  check_size(checks, "width.crowning", width.crowning, most_widening, "m");
  check_pair(checks, "width.tilt", width.tilt, most_slope, "rad", "[\"0.2 mrad\", \"0 mrad\"]");
  if (!width.moment.empty())
    check_pair(checks, "width.moment", width.moment, most_moment, "N m", "[\"50 N mm\", \"0 N mm\"]");
  checks.require_for("film", width.moment.empty(), "width.moment", "", "needs a bearing that balances it",
                     "give width.tilt, or run equilibrium");
  checks.require_for(experiments_where(&CaseTable::rotor), width.moment.empty(), "width.moment", "",
                     "is not supported under a rotor, which exerts its own moments on the bearings",
                     "remove it, or give width.tilt for bearings that are misaligned");
  const char* const key = !width.moment.empty()   ? "width.moment"
                          : width.tilts()         ? "width.tilt"
                          : width.conicity != 0.0 ? "width.conicity"
                          : width.crowning != 0.0 ? "width.crowning"
                                                  : nullptr;
  if (key != nullptr) check_dry_width(checks, input, key);
}

/// Unsupported combinations of bump foils split into strips.
void check_strips_in_use(Checks& checks, const Case& input) {
  const bool apart = input.bump_foil.is_split() && input.varies_over_the_width();
  checks.require_for(experiments_where(&CaseTable::is_dry), !apart || input.solver.chosen() != SolverName::uzawa,
                     "solver.name", std::string(name_of(input.solver.chosen())),
                     "does not support strips that move independently", "set name = \"newton\" or \"events\"");
  if (!input.has_own_strips()) return;
  checks.require_for(experiments_where(&CaseTable::foils), input.width.modes != 1 || input.top_foil.split,
                     "bump_foil.strip", "", "needs a top foil that can follow strips that differ",
                     "set width.modes = 3, or 2 without a parabola");
  if (input.top_foil.split) return;  // each strip has a mesh of its own
  const int step = input.bump_foil.least_columns_per_pitch();
  const int columns = input.film.columns_per_pitch;
  checks.require_for(experiments_where(&CaseTable::has_foils_on_film), columns % 2 != 0 || columns % step == 0,
                     "film.columns_per_pitch", std::to_string(columns),
                     "puts no column over the crests of strips staggered by other than 0.5",
                     fmt::format("give a multiple of {}", step));
}

/// Unsupported combinations if the film varies over the width.
void check_width(Checks& checks, const Case& input) {
  check_strips_in_use(checks, input);
  check_journal(checks, input);
  const int modes = input.width.modes;
  checks.require(!input.width.sheet || (modes >= 3 && !input.bump_foil.is_split()), "width.sheet", "true",
                 input.bump_foil.is_split() ? "applies to a bump foil in one piece; strips slide independently"
                                            : "needs foils with a parabola over the width",
                 input.bump_foil.is_split() ? "remove it" : "set width.modes = 3, or remove it");
  if (!checks.require(modes >= 1 && modes <= most_modes, "width.modes", std::to_string(modes),
                      "is not a number of modes over the width",
                      fmt::format("give 1 (uniform), 2 (also linear), 3 (also a parabola), or up to {}", most_modes)) ||
      modes == 1) {
    return;
  }
  checks.require_for("film", false, "width.modes", std::to_string(modes),
                     "applies to foils, and the command film has none", "set width.modes = 1, or run equilibrium");
}

/// Keys that do not apply to a bearing surface without foils.
void check_wall(Checks& checks, const Case& input) {
  checks.require_for("film", input.pads.empty(), "pad", "",
                     "are parts of the sleeve: a bearing surface without foils has none",
                     "remove them, or run equilibrium, which supports pads");
  const EquilibriumSettings* const equilibrium = input.settings.find<EquilibriumSettings>();
  checks.require_for("film", equilibrium != nullptr && !equilibrium->positions.empty(), "equilibrium.positions", "",
                     "no position specified", "give a list such as [[\"15 um\", \"0 um\"]] instead of loads");
  if (!input.film.closed) return;
  checks.require_for("film", input.bearing.taper == 0.0, "bearing.taper", "",
                     "makes a step in a surface without a slot", "remove it, or set film.closed = false");
  checks.require_for("film", !input.film.inlet_pressure, "film.inlet_pressure", "",
                     "feeds an edge, and a closed surface has none", "remove it, or set film.closed = false");
}

/// Foils on which no film can run.
void check_foils_on_film(Checks& checks, const Case& input) {
  const std::vector<std::string_view> running = experiments_where(&CaseTable::has_foils_on_film);
  checks.require_for(running, input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
                     std::string(name_of(input.bump_foil.model)), "has no top foil that a film could run on",
                     "set model = \"truss\" or \"frame\"");
  checks.require_for(running, input.bump_foil.geometry == Geometry::linear, "bump_foil.geometry",
                     std::string(name_of(input.bump_foil.geometry)),
                     "a film supports foils of small displacements only", "set geometry = \"linear\"");
  checks.require_for(running, input.solver.chosen() == SolverName::newton, "solver.name",
                     std::string(name_of(input.solver.chosen())), "cannot solve contacts under a film",
                     "set name = \"newton\"");
}

void check_film(Checks& checks, const Case& input, const CheckedBumpFoil& foil) {
  check_wall(checks, input);
  check_width(checks, input);
  check_gas(checks, input.gas);
  if (input.asperity) check_asperity(checks, *input.asperity);
  const bool together = input.lets_strips_move_apart() && !input.top_foil.split;
  const double stations = together ? static_cast<double>(input.bump_foil.stations().size()) : 1.0;
  check_film(checks, input.film, foil.bumps ? film_bumps(input) : 0, stations, input.has_equal_halves());
  checks.require_for("film", !input.asperity, "asperity", "",
                     "applies to journal and top foil, and the command film has no foils",
                     "remove [asperity], or run equilibrium");
  checks.require_for(experiments_where(&CaseTable::film), input.bearing.journal == RadiusProfile{}, "bearing", "",
                     "has an out-of-round journal, under which a film is never steady",
                     "remove journal_waviness and journal_profile");
  check_foils_on_film(checks, input);
}

}  // namespace

void describe_own_film(CaseVisitor& keys, const Case& common, RotorBearing& own) {
  using enum Presence;
  const auto own_part = [&keys](std::string_view name, std::string_view title, std::string_view text,
                                const auto& members, auto& held) {
    own_table(keys, {name, inherited, title, text}, members, held,
              [](CaseVisitor& inner, auto& visited) { describe(inner, visited); });
  };
  own_part("gas", "Its gas", "any keys of [gas] that differ", common.gas, own.gas);
  own_part("film", "Its film", "any keys of [film] that differ", common.film, own.film);
  own_part("width", "Its width", "any keys of [width] that differ", common.width, own.width);
  own_part("asperity", "Its mixed contact", "any keys of [asperity] that differ",
           common.asperity.value_or(AsperitySettings{}), own.asperity);
}

CaseTable film_settings() {
  return {.experiment = "film", .needs = "equilibrium", .film = true, .describe = describe_film, .check = check_film};
}

}  // namespace bumpfoil
