#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "experiments/equilibrium/equilibrium_json.hpp"
#include "experiments/equilibrium/film_ross_toml.hpp"
#include "experiments/equilibrium/running_dataset.hpp"
#include "experiments/equilibrium/whirl_quantities.hpp"
#include "results/result_files.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const EquilibriumResult& result, const PathSpread& spread) {
  const FilmBearing& bearing = *result.bearing;
  Json json;
  json["states"] = spread.states;
  for (const RunningQuantity& quantity : running_quantities(bearing)) {
    if (quantity.form.kind != Form::real && quantity.name != "loaded_bumps") continue;
    if (quantity.is(tag::requested) && quantity.name == "wall_time") continue;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const std::size_t i : spread.states) {
      const double value = value_of(quantity, bearing, result.states[i]);
      least = std::min(least, value);
      most = std::max(most, value);
    }
    json[quantity.key()] = {{"min", value_json(least, {})}, {"max", value_json(most, {})}};
  }
  return json;
}

Json equilibrium_lists(const Case& input, const EquilibriumResult& result) {
  Json json{{"states", Json::array()}, {"spreads", Json::array()}, {"limits", Json::array()}};
  for (const RunningState& state : result.states) json["states"].push_back(state_json(*result.bearing, state));
  for (const PathSpread& spread : path_spreads(result)) json["spreads"].push_back(spread_json(result, spread));
  for (const FilmLimit& limit : result.limits) json["limits"].push_back(limit_json(limit));
  json["warnings"] = warning_lines(input, result);
  return json;
}

std::vector<TableFile> tables_of(const EquilibriumResult& result) {
  std::vector<TableFile> tables{{fmt::format("{}.csv", command_of(result)), state_table(result)}};
  if (result.bearing->has_foils()) tables.push_back({"coefficients.csv", film_coefficient_table(result)});
  return tables;
}

std::vector<ResultFile> texts_of(const Case& input, const EquilibriumResult& result, const std::string& run_id) {
  if (!result.bearing->has_foils()) return {};
  return {{"coefficients.toml", film_ross_toml(input, result, run_id)}};
}

}  // namespace

std::vector<std::string> equilibrium_file_names(std::string_view command) {
  const std::string csv = fmt::format("{}.csv", command);
  if (command == "film") return {"summary.json", csv, "result.nc"};
  return {"summary.json", csv, "coefficients.csv", "coefficients.toml", "result.nc"};
}

Table state_table(const EquilibriumResult& result) {
  Table table;
  for (const RunningQuantity& quantity : running_quantities(*result.bearing, result.with_limits)) {
    if (!quantity.is(tag::csv)) continue;
    table.add(quantity.meaning(), each(result.states, [&](const RunningState& state) {
                return value_of(quantity, *result.bearing, state);
              }));
  }
  return table;
}

Table film_coefficient_table(const EquilibriumResult& result) {
  struct Row {
    const RunningState& state;
    const FilmWhirl& whirl;
  };
  std::vector<Row> rows;
  for (const RunningState& state : result.states) {
    if (!state.found()) continue;
    for (const FilmWhirl& whirl : state.whirls) rows.push_back({state, whirl});
  }
  Table table;
  table.add({"speed", "rad/s", ""}, each(rows, [](const Row& row) { return row.state.requested.speed; }));
  for (const int axis : {0, 1}) {
    table.add({axis == 0 ? "load_x" : "load_y", "N", ""}, each(rows, [axis](const Row& row) {
                return row.state.requested.by_load() ? row.state.requested.journal[axis] : absent;
              }));
  }
  for (const int axis : {0, 1}) {
    table.add({axis == 0 ? "x" : "y", "m", ""},
              each(rows, [axis](const Row& row) { return row.state.last->position[axis]; }));
  }
  table.add({"path", "", ""}, each(rows, [](const Row& row) { return std::string(name_of(row.state.path)); }));
  table.add({"frequency", "rad/s", ""}, each(rows, [](const Row& row) { return row.whirl.frequency; }));
  for (const WhirlQuantity& quantity : whirl_quantities(result.bearing->motions())) {
    table.add({quantity.name(), quantity.unit, quantity.long_name},
              each(rows, [&quantity](const Row& row) { return quantity.value(row.whirl); }));
  }
  return table;
}

std::vector<PathSpread> path_spreads(const EquilibriumResult& result) {
  std::vector<PathSpread> spreads;
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    const RunningState& state = result.states[i];
    if (!state.found()) continue;
    const auto same = std::find_if(spreads.begin(), spreads.end(), [&](const PathSpread& spread) {
      const RunningState& first = result.states[spread.states.front()];
      return first.requested == state.requested && first.path != state.path;
    });
    if (same == spreads.end()) {
      spreads.push_back({{i}});
    } else {
      same->states.push_back(i);
    }
  }
  std::erase_if(spreads, [](const PathSpread& spread) { return spread.states.size() < 2; });
  return spreads;
}

std::vector<ResultFile> equilibrium_files(const Case& input, const EquilibriumResult& result, RunStatus status,
                                          const Provenance& provenance) {
  return make_result_files({.input = input,
                            .command = command_of(result),
                            .status = status,
                            .message = message_of(failure_lines(result), status),
                            .warnings = warning_lines(input, result),
                            .provenance = provenance},
                           "result.nc", "use fewer states or a coarser mesh", [&](const std::string& run_id) {
                             return ResultContents{.tables = tables_of(result),
                                                   .texts = texts_of(input, result, run_id),
                                                   .dataset = state_dataset(input, result),
                                                   .lists = [&] { return equilibrium_lists(input, result); }};
                           });
}

}  // namespace bumpfoil
