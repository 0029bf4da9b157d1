#include "pages/shown_states.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/base64.hpp"
#include "experiments/equilibrium/state_grid.hpp"
#include "pages/shown_run.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json grid_dimensions_json(const ResultGrid& grid) {
  Json json = Json::object();
  for (const auto& [name, size] : grid.dims) json[name] = size;
  return json;
}

Json grid_variables_json(const ResultGrid& grid) {
  std::map<std::string, std::size_t> sizes;
  for (const auto& [name, size] : grid.dims) sizes.emplace(name, size);
  Json json = Json::object();
  for (const auto* variables : {&grid.coordinates, &grid.variables}) {
    for (const GridVariable& variable : *variables) {
      const VariableMeaning& meaning = variable.meaning;
      std::vector<double> values = variable.values;
      if (values.empty()) {
        std::size_t size = 1;
        for (const std::string& dim : variable.dims) size *= sizes.at(dim);
        values.assign(size, absent);
      }
      json[meaning.name] = {{"key", key_of(meaning.name, meaning.unit)},
                            {"dims", variable.dims},
                            {"unit", meaning.unit == "1" ? "" : meaning.unit},
                            {"text", meaning.long_name},
                            {"words", fmt::format("{}", fmt::join(meaning.form.words, " "))},
                            {"values", base64_of(values)}};
    }
  }
  return json;
}

Json running_quantities_json(const FilmBearing& bearing) {
  Json json = Json::array();
  for (const RunningQuantity& quantity : running_quantities(bearing)) {
    Json shown =
        shown_quantity(quantity.name, quantity.unit, shown_label(quantity.label, quantity.name), quantity.long_name);
    shown["whole"] = quantity.form.kind == Form::whole;
    shown["of_solver"] = false;
    json.push_back(std::move(shown));
  }
  return json;
}

}  // namespace

Json shown_states(const Case& input, const EquilibriumResult& result) {
  const ResultGrid grid = state_grid(input, result);
  return {{"kind", command_of(result)},
          {"attributes",
           {{"title", input.title},
            {"status_message", fmt::format("{}", fmt::join(failure_lines(result), "; "))},
            {"warnings", fmt::format("{}", fmt::join(warning_lines(input, result), "\n"))}}},
          {"summary", summary_head(command_of(result), input, status_of(result), {})},
          {"dimensions", grid_dimensions_json(grid)},
          {"variables", grid_variables_json(grid)},
          {"left_out", Json::array()},
          {"quantities", running_quantities_json(*result.bearing)}};
}

}  // namespace bumpfoil
