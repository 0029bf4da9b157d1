#include "pages/shown_states.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/base64.hpp"
#include "experiments/equilibrium/running_dataset.hpp"
#include "pages/shown_run.hpp"
#include "results/summary_json.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

Json dimensions_json(const Dataset& data) {
  Json json = Json::object();
  for (const DataDimension& dim : data.dims) json[dim.name] = dim.size;
  return json;
}

Json variables_json(const Dataset& data) {
  Json json = Json::object();
  for (const std::vector<Variable>* variables : {&data.coordinates, &data.variables}) {
    for (const Variable& variable : *variables) {
      const VariableMeaning& meaning = variable.meaning;
      std::vector<double> values = variable.values();
      if (values.empty()) values.assign(data.size_of(variable), absent);
      json[meaning.name] = {{"key", meaning.key()},
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
    json.push_back(shown_quantity(labelled(quantity.meaning())));
  }
  return json;
}

}  // namespace

Json shown_states(const Case& input, const EquilibriumResult& result) {
  const Dataset data = state_dataset(input, result);
  return {{"kind", command_of(result)},
          {"attributes",
           {{"title", input.title},
            {"status_message", fmt::format("{}", fmt::join(failure_lines(result), "; "))},
            {"warnings", fmt::format("{}", fmt::join(warning_lines(input, result), "\n"))}}},
          {"summary", summary_head(command_of(result), input, status_of(result), {})},
          {"dimensions", dimensions_json(data)},
          {"variables", variables_json(data)},
          {"left_out", Json::array()},
          {"quantities", running_quantities_json(*result.bearing)}};
}

}  // namespace bumpfoil
