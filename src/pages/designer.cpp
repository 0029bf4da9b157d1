#include "bumpfoil/pages/designer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/ensemble/sample.hpp"
#include "bumpfoil/ensemble/statistics.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/increment_rows.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/cycle/sampled_cycles.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "bumpfoil/experiments/properties/properties.hpp"
#include "bumpfoil/experiments/properties/properties_report.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/stability/stability.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/results/csv_text.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "case/key_list.hpp"
#include "case/presets.hpp"
#include "case/units.hpp"
#include "ensemble/statistics_json.hpp"
#include "experiments/equilibrium/equilibrium_json.hpp"
#include "pages/shown_run.hpp"
#include "pages/shown_states.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Empty name of the case in messages: there is only one.
const std::string no_name;

/// @param commands  with the same results
Case read(const Json& request, std::vector<std::string> commands) {
  return parse_case(request.at("text").get<std::string>(), no_name, {.overrides = {}, .commands = std::move(commands)});
}

// What the page begins with -----------------------------------------------------------------------------------------

/// Display units of each dimension, including the SI unit.
struct OfferedUnits {
  Dimension dimension;
  std::vector<const char*> units;
};

std::vector<OfferedUnits> offered_units() {
  return {{Dimension::length, {"m", "mm", "um", "nm", "inch", "mil"}},
          {Dimension::angle, {"rad", "mrad", "deg"}},
          {Dimension::force, {"N", "mN", "kN", "lbf"}},
          {Dimension::stiffness, {"N/m", "kN/m", "MN/m", "GN/m", "N/mm", "N/um"}},
          {Dimension::pressure, {"Pa", "kPa", "MPa", "GPa", "bar", "psi"}},
          {Dimension::frequency, {"rad/s", "Hz", "rpm"}},
          {Dimension::temperature, {"K"}},
          {Dimension::viscosity, {"Pa s", "mPa s", "uPa s"}},
          {Dimension::foundation_modulus, {"Pa/m", "MPa/m", "GPa/m"}},
          {Dimension::moment, {"N m", "N mm"}},
          {Dimension::acceleration, {"m/s2"}},
          {Dimension::mass, {"kg", "g", "lb"}}};
}

Json units_json() {
  Json json = Json::object();
  for (const auto& [dimension, units] : offered_units()) {
    Json& sizes = json[std::string(si_unit(dimension))];
    for (const char* unit : units) sizes[unit] = std::get<double>(parse_quantity(std::string("1 ") + unit, dimension));
  }
  return json;
}

std::string_view presence_text(Presence presence) {
  switch (presence) {
    case Presence::required:
      return "required";
    case Presence::optional:
      return "optional";
    case Presence::defaulted:
      return "defaulted";
    case Presence::inherited:
      return "inherited";
  }
  return {};
}

Json keys_json() {
  Json json = Json::array();
  for (const ListedKey& listed : list_keys(reference_case())) {
    const Key& key = listed.key;
    json.push_back({{"path", listed.path},
                    {"title", key.title},
                    {"text", key.text},
                    {"kind", listed.kind},
                    {"presence", presence_text(key.presence)}});
    if (listed.is_table()) continue;
    if (key.dimension) json.back()["unit"] = si_unit(*key.dimension);
    if (!key.otherwise.empty()) json.back()["otherwise"] = key.otherwise;
    json.back()["example"] = example_of(listed);
    json.back()["value"] = listed.value;
  }
  return json;
}

Json answer_keys() {
  Json presets = Json::object();
  for (const Preset& preset : bumpfoil::presets()) {
    if (preset.input.pads.empty()) presets[std::string(preset.name)] = case_template(preset.name);
  }
  return {{"version", version()},
          {"commit", commit()},
          {"keys", keys_json()},
          {"units", units_json()},
          {"presets", presets}};
}

// Results -----------------------------------------------------------------------------------------------------------

/// Selects one of several nearly equal parts of a list, in order. @param part  index from 0, and number of parts
std::vector<double> part_of(const std::vector<double>& all, const std::array<std::size_t, 2>& part) {
  const auto end = [&](std::size_t parts) {
    return all.begin() + static_cast<std::ptrdiff_t>(parts * all.size() / part[1]);
  };
  return {end(part[0]), end(part[0] + 1)};
}

Json answer_cycles(const Json& request) {
  const Case input = read(request, {"cycle"});
  Case own = input;
  const std::array<std::size_t, 2> whole{0, 1};
  std::vector<double>& directions = own.settings.get<CycleSettings>().directions;
  directions = part_of(directions, request.value("part", whole));
  // There may be fewer directions than parts.
  if (directions.empty()) return {{"run", shown_run(input, {.solver = input.solver.chosen(), .cycles = {}})}};
  return {{"run", shown_run(input, run_cycles(own))}};
}

Json answer_csv(const Json& request) {
  return {{"csv", csv_text(increment_rows(run_cycles(read(request, {"cycle"}))))}};
}

Json answer_properties(const Json& request) {
  const Case input = read(request, {});
  return Json::parse(properties_json(input, compute_properties(input)));
}

Json answer_vibration(const Json& request) {
  Case input = read(request, {});
  const auto load = request.at("load").get<std::array<double, 2>>();
  const VibrationSettings& vibration =
      input.settings.set(VibrationSettings{.loads = {{load[0], load[1]}},
                                           .directions = {0.0, 0.5 * std::numbers::pi},
                                           .amplitudes = request.at("amplitudes").get<std::vector<double>>(),
                                           .frequencies = {1.0},
                                           .steps = request.at("steps").get<int>()});
  const VibrationResult result = run_vibration(input);
  const std::vector<LinearFoils> foils = linear_foils(vibration, result);
  Json json{{"position_m", {result.loads.front().position.x(), result.loads.front().position.y()}},
            {"status", name_of(result.loads.front().status)},
            {"directions", Json::array()}};
  const std::size_t amplitudes = vibration.amplitudes.size();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    Json direction{{"stiffness", Json::array()}, {"loss_factor", Json::array()}, {"dissipation", Json::array()}};
    for (std::size_t k = 0; k < amplitudes; ++k) {
      direction["stiffness"].push_back(value_json(foils[k].stiffness(i, i)));
      direction["loss_factor"].push_back(value_json(foils[k].loss_factor[i]));
      direction["dissipation"].push_back(
          value_json(result.vibrations[axis * amplitudes + k].cycle.loop_energy.value_or(std::nan(""))));
    }
    json["directions"].push_back(std::move(direction));
  }
  return json;
}

/// Limits the film mesh to this resolution, except for columns required by crests.
void coarsen(Case& input, const std::array<int, 2>& mesh) {
  const int step = input.bump_foil.least_columns_per_pitch();
  const int columns = (mesh[0] + step - 1) / step * step;
  const auto coarsen_film = [&](FilmSettings& film) {
    film.columns_per_pitch = std::min(film.columns_per_pitch, columns);
    film.rows = std::min(film.rows, mesh[1]);
  };
  coarsen_film(input.film);
  for (RotorBearing& own : input.rotor_bearings) {
    if (own.film) coarsen_film(*own.film);
  }
}

/// The settings of the case, if any, at speeds with loads or at positions.
EquilibriumSettings operating_points(const Json& request, const Case& input) {
  const EquilibriumSettings* const held = input.settings.find<EquilibriumSettings>();
  EquilibriumSettings settings = held == nullptr ? EquilibriumSettings{} : *held;
  const auto vectors = [&request](const char* key) {
    std::vector<Eigen::Vector2d> all;
    if (!request.contains(key)) return all;
    for (const auto& [x, y] : request.at(key).get<std::vector<std::array<double, 2>>>()) all.emplace_back(x, y);
    return all;
  };
  settings.speeds = request.at("speeds").get<std::vector<double>>();
  settings.loads = vectors("loads");
  settings.positions = vectors("positions");
  settings.limits = false;
  // Positions have no load for a ramp.
  if (settings.loads.empty() && settings.path == FilmPath::load_ramp) settings.path = FilmPath::position_ray;
  return settings;
}

Json answer_equilibrium(const Json& request) {
  Case input = read(request, {});
  if (request.contains("sample")) {
    // Ensembles of cycles have a different default solver.
    const SolverSettings solver = input.solver;
    input = read(request, {"montecarlo"});
    input = sampled_case(input, draw_sample(input, request.at("sample").get<std::uint64_t>()));
    input.solver = solver;
  }
  input.settings.set(operating_points(request, input));
  if (request.contains("mesh")) {
    coarsen(input, request.at("mesh").get<std::array<int, 2>>());
    input.settings.get<EquilibriumSettings>().paths = ComparedPaths::one;
  }
  const EquilibriumResult result = run_equilibrium(input);
  Json states = Json::array();
  for (const RunningState& state : result.states) states.push_back(state_json(*result.bearing, state));
  return {{"run", shown_states(input, result)}, {"states", std::move(states)}};
}

Json answer_stability(const Json& request) {
  Case input = read(request, {});
  if (request.contains("mesh")) coarsen(input, request.at("mesh").get<std::array<int, 2>>());
  input.settings.set(StabilitySettings{.speeds = request.at("speeds").get<std::vector<double>>()});
  return {{"run", shown_rotor(input, run_stability(input))}};
}

/// Whether the page shows this quantity for ensembles.
bool is_shown_of_samples(const CycleQuantity& quantity) {
  return quantity.is(tag::sampled) && quantity.form.kind == Form::real && quantity.shown.size > 0.0 &&
         !quantity.is(tag::of_solver);
}

double number_of(const Json& value) {
  return value.is_null() ? absent : value.get<double>();
}

Json answer_samples(const Json& request) {
  const Case input = read(request, {"montecarlo", "cycle"});
  std::vector<CycleQuantity> quantities;
  Json shown = Json::array();
  for (const CycleQuantity& quantity : cycle_quantities(Experiment::cycle)) {
    if (!is_shown_of_samples(quantity)) continue;
    quantities.push_back(quantity);
    shown.push_back(shown_quantity(quantity.meaning()));
  }
  Json samples = request.value("before", Json::array());
  const auto first = request.at("first").get<std::uint64_t>();
  const auto count = request.at("count").get<std::uint64_t>();
  const std::size_t directions_of_case = input.settings.get<CycleSettings>().directions.size();
  for (std::uint64_t number = first; number < first + count; ++number) {
    const Case sampled = sampled_case(input, draw_sample(input, number));
    Json directions = Json::array();
    const std::optional<CycleResult> result = run_sampled_cycles(sampled);
    for (std::size_t i = 0; i < directions_of_case; ++i) {
      Json values = Json::array();
      for (const CycleQuantity& quantity : quantities) {
        values.push_back(result ? value_json(quantity.value(result->cycles[i], sampled)) : Json());
      }
      directions.push_back(std::move(values));
    }
    samples.push_back(std::move(directions));
  }
  Json statistics = Json::array();
  for (std::size_t direction = 0; direction < directions_of_case; ++direction) {
    Json of_direction;
    for (std::size_t k = 0; k < quantities.size(); ++k) {
      of_direction[quantities[k].key()] = statistics_json(
          statistics_of(each(samples, [&](const Json& sample) { return number_of(sample.at(direction).at(k)); })));
    }
    statistics.push_back(std::move(of_direction));
  }
  return {{"quantities", shown}, {"samples", samples}, {"statistics", statistics}};
}

Json answer_statistics(const Json& request) {
  return statistics_json(statistics_of(each(request.at("values"), number_of)));
}

Json errors_json(const Error& error) {
  Json json = Json::array();
  for (const InputError& one : error.errors()) {
    json.push_back({{"line", one.line},
                    {"key", one.key},
                    {"value", one.value},
                    {"what", one.what},
                    {"advice", one.advice},
                    {"message", format_error(one)}});
  }
  return {{"errors", json}};
}

Json answer_json(const Json& request) {
  const auto what = request.at("what").get<std::string>();
  if (what == "keys") return answer_keys();
  if (what == "cycles") return answer_cycles(request);
  if (what == "csv") return answer_csv(request);
  if (what == "properties") return answer_properties(request);
  if (what == "vibration") return answer_vibration(request);
  if (what == "equilibrium") return answer_equilibrium(request);
  if (what == "stability") return answer_stability(request);
  if (what == "samples") return answer_samples(request);
  if (what == "statistics") return answer_statistics(request);
  throw Error(ErrorKind::input, {{"", 0, "what", what, "is not a request", ""}});
}

}  // namespace

std::string designer_answer(std::string_view request) {
  Json json;
  try {
    json = answer_json(Json::parse(request));
  } catch (const Error& error) {
    json = errors_json(error);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace bumpfoil
