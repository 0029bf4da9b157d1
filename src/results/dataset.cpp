#include "bumpfoil/results/dataset.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

void Dataset::add_dimension(VariableMeaning meaning, std::vector<double> values) {
  dims.push_back({meaning.name, values.size()});
  add_coordinate(std::move(meaning), {dims.back().name}, std::move(values));
}

Variable& Dataset::add_coordinate(VariableMeaning meaning, std::vector<std::string> over, std::vector<double> values) {
  return coordinates.emplace_back(Variable{.meaning = std::move(meaning),
                                           .dims = std::move(over),
                                           .values = [values = std::move(values)] { return values; },
                                           .known = true});
}

Variable& Dataset::add(VariableMeaning meaning, std::vector<std::string> over,
                       std::function<std::vector<double>()> values) {
  return variables.emplace_back(
      Variable{.meaning = std::move(meaning), .dims = std::move(over), .values = std::move(values)});
}

Variable& Dataset::add(VariableMeaning meaning, std::vector<std::string> over, std::vector<double> values) {
  return add(std::move(meaning), std::move(over), [values = std::move(values)] { return values; });
}

const DataDimension& Dataset::dimension(const std::string& name) const {
  const auto found = std::find_if(dims.begin(), dims.end(), [&](const DataDimension& one) { return one.name == name; });
  BUMPFOIL_ASSERT(found != dims.end());
  return *found;
}

std::size_t Dataset::size_of(const std::string& name) const {
  return dimension(name).size;
}

bool Dataset::grows(const Variable& variable) const {
  return !variable.rows && !variable.dims.empty() && dimension(variable.dims.front()).grows;
}

std::size_t Dataset::size_of(const Variable& variable) const {
  return std::accumulate(variable.dims.begin(), variable.dims.end(), std::size_t{1},
                         [this](std::size_t size, const std::string& name) { return size * size_of(name); });
}

std::vector<double> numbers_from(double first, std::size_t count) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

}  // namespace bumpfoil
