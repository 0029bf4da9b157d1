#include "pages/grid_reader.hpp"

#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "core/base64.hpp"

namespace bumpfoil {
namespace {

using Json = nlohmann::ordered_json;

/// Not as a whole number: damaged files declare any.
double size_of(const StoredVariable& variable) {
  return std::accumulate(variable.extents.begin(), variable.extents.end(), 1.0, std::multiplies<>());
}

/// Of bumps or feet, which are many; pads are not.
bool is_of_nodes(const StoredVariable& variable) {
  return std::any_of(variable.dims.begin(), variable.dims.end(),
                     [](const std::string& dimension) { return is_node(dimension) && dimension != "pad"; });
}

/// As few of the largest as it takes are left out, and with them those of the same size: one coordinate of a loop says
/// nothing without the other.
std::vector<const StoredVariable*> those_that_fit(std::vector<const StoredVariable*> variables,
                                                  std::size_t most_values) {
  std::stable_sort(variables.begin(), variables.end(),
                   [](const StoredVariable* a, const StoredVariable* b) { return size_of(*a) < size_of(*b); });
  double values = 0.0;
  const auto too_many = [&](const StoredVariable* variable) {
    values += size_of(*variable);
    return values > static_cast<double>(most_values);
  };
  const auto last = std::find_if(variables.begin(), variables.end(), too_many);
  if (last == variables.end()) return variables;
  const auto as_large = [size = size_of(**last)](const StoredVariable* variable) { return size_of(*variable) >= size; };
  variables.erase(std::find_if(variables.begin(), variables.end(), as_large), variables.end());
  return variables;
}

Json variable_json(const NetcdfImage& file, const StoredVariable& variable) {
  return {{"key", key_of(variable.name, variable.units)},
          {"dims", variable.dims},
          {"unit", variable.units == "1" ? "" : variable.units},
          {"text", variable.long_name},
          {"words", variable.flag_meanings},
          {"values", base64_of(file.numbers(variable))}};
}

}  // namespace

bool is_node(std::string_view dimension) {
  return std::find(node_dimensions.begin(), node_dimensions.end(), dimension) != node_dimensions.end();
}

Json read_grid(const NetcdfImage& file, std::size_t most_values, Nodes nodes) {
  std::vector<const StoredVariable*> shown;
  for (const auto& [name, variable] : file.variables()) {
    if (nodes == Nodes::read || !is_of_nodes(variable)) shown.push_back(&variable);
  }
  Json variables = Json::object();
  Json dimensions = Json::object();
  for (const StoredVariable* variable : those_that_fit(shown, most_values)) {
    variables[variable->name] = variable_json(file, *variable);
    for (std::size_t i = 0; i < variable->dims.size(); ++i) dimensions[variable->dims[i]] = variable->extents[i];
  }
  Json left_out = Json::array();
  for (const StoredVariable* variable : shown) {
    if (!variables.contains(variable->name)) left_out.push_back(variable->name);
  }
  return {{"dimensions", dimensions}, {"variables", variables}, {"left_out", left_out}};
}

}  // namespace bumpfoil
