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

/// Rows read at a time of variables with many.
constexpr std::size_t grid_rows_at_once = 10'000;

/// A variable, and the rows to read.
struct GridPart {
  const StoredVariable* variable{};
  const std::vector<std::size_t>* rows{};  ///< null: all

  [[nodiscard]] std::vector<std::size_t> extents() const {
    std::vector<std::size_t> extents = variable->extents;
    if (rows != nullptr) extents.front() = rows->size();
    return extents;
  }
};

/// As floating point: damaged files may declare any size.
double size_of(const GridPart& part) {
  const std::vector<std::size_t> extents = part.extents();
  return std::accumulate(extents.begin(), extents.end(), 1.0, std::multiplies<>());
}

/// Omits as few of the largest variables as necessary, together with all others of the same size: one coordinate of a
/// loop is useless without the other.
std::vector<GridPart> those_that_fit(std::vector<GridPart> parts, std::size_t most_values) {
  std::stable_sort(parts.begin(), parts.end(),
                   [](const GridPart& a, const GridPart& b) { return size_of(a) < size_of(b); });
  double values = 0.0;
  const auto too_many = [&](const GridPart& part) {
    values += size_of(part);
    return values > static_cast<double>(most_values);
  };
  const auto last = std::find_if(parts.begin(), parts.end(), too_many);
  if (last == parts.end()) return parts;
  const auto as_large = [size = size_of(*last)](const GridPart& part) { return size_of(part) >= size; };
  parts.erase(std::find_if(parts.begin(), parts.end(), as_large), parts.end());
  return parts;
}

/// Reads in stretches of a limited number of rows.
std::vector<double> numbers_of(const NetcdfImage& file, const GridPart& part) {
  if (part.rows == nullptr) return file.numbers(*part.variable);
  std::vector<std::size_t> start(part.variable->extents.size());
  std::vector<std::size_t> count = part.variable->extents;
  std::vector<double> numbers;
  for (auto row = part.rows->begin(); row != part.rows->end();) {
    const auto end = std::lower_bound(row, part.rows->end(), *row + grid_rows_at_once);
    start.front() = *row;
    count.front() = *(end - 1) - *row + 1;
    const std::vector<double> all = file.numbers(*part.variable, start, count);
    const std::size_t width = all.size() / count.front();
    for (; row != end; ++row) {
      const auto from = all.begin() + static_cast<std::ptrdiff_t>((*row - start.front()) * width);
      numbers.insert(numbers.end(), from, from + static_cast<std::ptrdiff_t>(width));
    }
  }
  return numbers;
}

Json variable_json(const NetcdfImage& file, const GridPart& part) {
  const StoredVariable& variable = *part.variable;
  return {{"key", key_of(variable.name, variable.units)},
          {"dims", variable.dims},
          {"unit", variable.units == "1" ? "" : variable.units},
          {"text", variable.long_name},
          {"words", variable.flag_meanings},
          {"values", base64_of(numbers_of(file, part))}};
}

}  // namespace

bool is_node(std::string_view dimension) {
  return std::find(node_dimensions.begin(), node_dimensions.end(), dimension) != node_dimensions.end();
}

bool is_of_nodes(const StoredVariable& variable) {
  return std::any_of(variable.dims.begin(), variable.dims.end(),
                     [](const std::string& dimension) { return is_node(dimension) && dimension != "pad"; });
}

Json read_grid(const NetcdfImage& file, std::size_t most_values, const GridParts& parts) {
  std::vector<GridPart> shown;
  for (const auto& [name, variable] : file.variables()) {
    if (!parts.has(variable)) continue;
    const auto rows = variable.dims.empty() ? parts.rows.end() : parts.rows.find(variable.dims.front());
    shown.push_back({&variable, rows == parts.rows.end() ? nullptr : &rows->second});
  }
  Json variables = Json::object();
  Json dimensions = Json::object();
  for (const GridPart& part : those_that_fit(shown, most_values)) {
    variables[part.variable->name] = variable_json(file, part);
    const std::vector<std::size_t> extents = part.extents();
    for (std::size_t i = 0; i < extents.size(); ++i) dimensions[part.variable->dims[i]] = extents[i];
  }
  Json left_out = Json::array();
  for (const GridPart& part : shown) {
    if (!variables.contains(part.variable->name)) left_out.push_back(part.variable->name);
  }
  return {{"dimensions", dimensions}, {"variables", variables}, {"left_out", left_out}};
}

}  // namespace bumpfoil
