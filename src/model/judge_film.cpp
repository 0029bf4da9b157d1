#include "model/judge_film.hpp"

#include <algorithm>
#include <optional>

#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/model/pads.hpp"

namespace bumpfoil {
namespace {

constexpr Range ambient_range{1e2, 1e8, "Pa"};
constexpr Range viscosity_range{1e-7, 1e-2, "Pa s"};
constexpr Range free_path_range{0.0, 1e-4, "m"};

/// Film meshes beyond these are input errors.
constexpr int most_columns = 100;
constexpr int most_film_rows = 200;
/// The equations must fit in memory. Bytes for each pair of rows: over a crest, where contacts are, and in a column;
/// fitted to what 26 bumps take on 6 x 50 to 12 x 200, within 15 %.
constexpr double bytes_at_crest = 285.0;
constexpr double bytes_of_column = 37.0;
constexpr double most_film_bytes = 2e9;
constexpr double most_speed = 1e6;  // rad/s

void judge_gas(Judge& judge, const GasSettings& gas) {
  const auto [least, most] = temperature_range(gas.preset);
  judge.require(gas.viscosity || (gas.temperature >= least && gas.temperature <= most), "gas.temperature",
                quantity(gas.temperature, "K"),
                fmt::format("the viscosity of {} is not available there", name_of(gas.preset)),
                fmt::format("give a temperature from {} to {} K, or gas.viscosity", least, most));
  if (gas.viscosity) judge.within("gas.viscosity", *gas.viscosity, viscosity_range);
  judge.within("gas.ambient_pressure", gas.ambient_pressure, ambient_range);
  judge.within("gas.mean_free_path", gas.mean_free_path, free_path_range);
}

/// @param bumps  their number, 0 where that is not usable
/// @param runs   whether there is to be a film
void judge_film(Judge& judge, const FilmSettings& film, int bumps, bool runs) {
  const int columns = film.columns_per_pitch;
  const bool columns_right = judge.require(
      columns >= 4 && columns <= most_columns && columns % 2 == 0, "film.columns_per_pitch", std::to_string(columns),
      "puts no column over every crest", fmt::format("give an even number from 4 to {}", most_columns));
  const bool rows_right =
      judge.require(film.rows >= 2 && film.rows <= most_film_rows, "film.rows", std::to_string(film.rows),
                    "is not a valid number of rows", fmt::format("give a whole number from 2 to {}", most_film_rows));
  if (runs && columns_right && rows_right) {
    const double bytes = static_cast<double>(bumps) * film.rows * film.rows *
                         (bytes_at_crest + bytes_of_column * static_cast<double>(columns));
    for (const char* const command : {"equilibrium", "film"}) {
      judge.require_for(command, bytes <= most_film_bytes, "film.columns_per_pitch", std::to_string(columns),
                        fmt::format("makes {} columns of {} rows, which need about {:.2g} GB of memory",
                                    columns * bumps, film.rows, 1e-9 * bytes),
                        fmt::format("give a mesh that needs {:.2g} GB at most", 1e-9 * most_film_bytes));
    }
  }
  if (film.wall != FilmWall::rigid) {
    judge.require(film.wall_stiffness.has_value(), "film.wall_stiffness", "",
                  "is missing, but the elastic foundation needs it",
                  "give a stiffness such as \"5 GPa/m\", or wall = \"rigid\"");
  }
  if (film.wall_stiffness) judge.within("film.wall_stiffness", *film.wall_stiffness, {1e3, 1e18, "Pa/m"});
  judge.within("film.h_floor", film.h_floor, {0.0, 1e-3, "m"});
  if (film.h_lift_off && judge.within("film.h_lift_off", *film.h_lift_off, {1e-9, 1e-3, "m"})) {
    judge.require(*film.h_lift_off > film.h_floor, "film.h_lift_off", quantity(*film.h_lift_off, "m"),
                  fmt::format("is not above film.h_floor, {:.6g} m, the contact threshold", film.h_floor),
                  "give a larger h_lift_off or a smaller h_floor");
  }
}

/// Entries of a list of pairs, each within +-`most`.
void judge_vectors(Judge& judge, const std::string& key, const std::vector<Eigen::Vector2d>& vectors, double most,
                   std::string_view unit) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (const int axis : {0, 1}) {
      const double value = vectors[i][axis];
      const std::string entry = fmt::format("{}[{}][{}]", key, i + 1, axis + 1);
      if (!judge.finite(entry, value, unit)) continue;
      judge.require(std::abs(value) <= most, entry, quantity(value, unit), "is unphysical",
                    fmt::format("give at most {} either way; is the unit right?", quantity(most, unit)));
    }
  }
}

/// Columns of the film are equally spaced, and each crest has one.
void judge_mesh_of(Judge& judge, const BumpFoil& foil) {
  const PerBump& pitch = foil.pitch;
  const auto other = [&](const std::optional<double>& one) { return one && *one != pitch.values.front(); };
  const bool equal =
      std::all_of(pitch.values.begin(), pitch.values.end(), [&](double one) { return one == pitch.values.front(); }) &&
      std::none_of(foil.sections.begin(), foil.sections.end(),
                   [&](const BumpSection& one) { return other(one.pitch); });
  judge.require_for("equilibrium", equal, "bump_foil.pitch", "",
                    "differs along the foil, and the mesh of a film needs equal pitches", "give one pitch");
}

void judge_equilibrium(Judge& judge, const Case& input) {
  const EquilibriumSettings& equilibrium = *input.equilibrium;
  judge.require(!equilibrium.speeds.empty(), "equilibrium.speeds", "", "no speed specified",
                "give a list such as [\"45000 rpm\"]");
  for (std::size_t i = 0; i < equilibrium.speeds.size(); ++i) {
    const double speed = equilibrium.speeds[i];
    const std::string entry = fmt::format("equilibrium.speeds[{}]", i + 1);
    if (!judge.finite(entry, speed, "rad/s")) continue;
    judge.require(speed != 0.0, entry, quantity(speed, "rad/s"), "a journal at rest has no film",
                  "give a speed that is not zero");
    judge.require(std::abs(speed) <= most_speed, entry, quantity(speed, "rad/s"), "is unphysical",
                  fmt::format("give at most {} rad/s either way; is the unit right?", most_speed));
  }
  const bool by_load = !equilibrium.loads.empty();
  judge.require_for("equilibrium", by_load || !equilibrium.positions.empty(), "equilibrium.loads", "",
                    "no load specified", "give a list such as [[\"50 N\", \"0 N\"]], or positions");
  judge.require(!by_load || equilibrium.positions.empty(), "equilibrium.positions", "",
                "conflicts with equilibrium.loads, which is also given", "give one of the two");
  judge.require(by_load || equilibrium.positions.empty() || equilibrium.path != FilmPath::load_ramp, "equilibrium.path",
                std::string(name_of(equilibrium.path)), "needs loads, but there are positions",
                "write path = \"position_ray\", \"speed_ramp\" or \"cold_start\"");
  judge_vectors(judge, "equilibrium.loads", equilibrium.loads, load_range.most, "N");
  judge_vectors(judge, "equilibrium.positions", equilibrium.positions, thin * input.bearing.radius, "m");
  for (std::size_t i = 0; i < equilibrium.loads.size(); ++i) {
    judge.require(!equilibrium.loads[i].isZero(0.0), fmt::format("equilibrium.loads[{}]", i + 1), "0 N",
                  "is zero, so the path to it has no direction", "give a load that is not zero, however small");
  }
  judge.require(equilibrium.steps >= 1 && equilibrium.steps <= most_steps, "equilibrium.steps",
                std::to_string(equilibrium.steps), "is not a valid number of increments",
                fmt::format("give a whole number from 1 to {}", most_steps));
  judge.require(equilibrium.ross_version == 2 || equilibrium.ross_version == 3, "equilibrium.ross_version",
                std::to_string(equilibrium.ross_version), "is a version that nothing is written for", "give 2 or 3");
  for (std::size_t i = 0; i < equilibrium.frequencies.size(); ++i) {
    judge.within(fmt::format("equilibrium.frequencies[{}]", i + 1), equilibrium.frequencies[i], frequency_range);
  }
  judge.require_for("equilibrium", input.bump_foil.model != BumpFoilModel::former, "bump_foil.model",
                    std::string(name_of(input.bump_foil.model)), "has no top foil that a film could run on",
                    "set model = \"truss\" or \"frame\"");
  judge.require_for("equilibrium", input.bump_foil.geometry == Geometry::linear, "bump_foil.geometry",
                    std::string(name_of(input.bump_foil.geometry)), "a film supports foils of small displacements only",
                    "set geometry = \"linear\"");
  judge_mesh_of(judge, input.bump_foil);
  judge.require_for("equilibrium", input.solver.chosen() == SolverName::newton, "solver.name",
                    std::string(name_of(input.solver.chosen())), "cannot solve contacts under a film", "use newton");
}

}  // namespace

void judge_film_settings(Judge& judge, const Case& input, bool bumps) {
  judge_gas(judge, input.gas);
  judge_film(judge, input.film, bumps ? total_bumps(input) : 0, input.equilibrium.has_value());
  for (const char* const command : {"equilibrium", "film"}) {
    judge.require_for(command, input.bearing.journal == RadiusProfile{}, "bearing", "",
                      "has an out-of-round journal, under which a film is never steady",
                      "remove journal_waviness and journal_profile");
  }
  judge.require_for("limits", input.film.h_lift_off.has_value(), "film.h_lift_off", "",
                    "is missing: the minimum film thickness at lift-off",
                    "give a thickness such as \"2 um\", three times the roughness of both surfaces together");
  judge.require_for("limits", input.equilibrium && !input.equilibrium->loads.empty(), "equilibrium.loads", "",
                    "no load specified", "give a list such as [[\"50 N\", \"0 N\"]]");
  if (input.equilibrium) judge_equilibrium(judge, input);
}

}  // namespace bumpfoil
