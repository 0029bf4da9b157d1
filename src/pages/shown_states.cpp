#include "pages/shown_states.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_quantities.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_tables.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/base64.hpp"
#include "experiments/equilibrium/running_dataset.hpp"
#include "experiments/stability/stability_dataset.hpp"
#include "experiments/stability/stability_json.hpp"
#include "experiments/stability/stability_quantities.hpp"
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

Json running_quantities_json(const BearingModel& bearing) {
  Json json = Json::array();
  for (const RunningQuantity& quantity : running_quantities(bearing)) {
    json.push_back(shown_quantity(labelled(quantity.meaning())));
  }
  return json;
}

Json rotor_quantities_json() {
  return each(meanings_of(stability_quantities(), speed_quantities(), motion_quantities()),
              [](const VariableMeaning& meaning) { return shown_quantity(labelled(meaning)); });
}

/// Numbers of a run. @param summary  the common header of summary.json, and further entries
template <typename Result>
Json shown_numbers(const Case& input, const Result& result, const Dataset& data, Json summary, Json quantities) {
  return {{"kind", summary.at("command")},
          {"attributes",
           {{"title", input.title},
            {"status_message", fmt::format("{}", fmt::join(failure_lines(result), "; "))},
            {"warnings", fmt::format("{}", fmt::join(warning_lines(input, result), "\n"))}}},
          {"summary", std::move(summary)},
          {"dimensions", dimensions_json(data)},
          {"variables", variables_json(data)},
          {"left_out", Json::array()},
          {"quantities", std::move(quantities)}};
}

}  // namespace

Json shown_states(const Case& input, const EquilibriumResult& result) {
  return shown_numbers(input, result, state_dataset(input, result),
                       summary_head(command_of(result), input, status_of(result), {}),
                       running_quantities_json(*result.bearing));
}

Json shown_rotor(const Case& input, const StabilityResult& result) {
  Json summary = summary_head("stability", input, status_of(result), {});
  summary["onsets"] = stability_lists(result).at("onsets");
  return shown_numbers(input, result, stability_dataset(result), std::move(summary), rotor_quantities_json());
}

}  // namespace bumpfoil
