#include "sweep/sweep_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

/// Copies a block of numbers over some dimensions into a larger one. @param extents  of the block, and of the other
void copy_block(const std::vector<double>& block, const std::vector<std::size_t>& extents,
                const std::vector<std::size_t>& larger, std::vector<double>::iterator out) {
  const std::size_t width = extents.empty() ? 1 : extents.back();
  std::vector<std::size_t> place(extents.size(), 0);
  for (std::size_t i = 0; i < block.size(); i += width) {
    std::size_t at = 0;
    for (std::size_t k = 0; k < place.size(); ++k) at = at * larger[k] + place[k];
    std::copy_n(block.begin() + static_cast<std::ptrdiff_t>(i), width, out + static_cast<std::ptrdiff_t>(at));
    for (std::size_t k = extents.size() - (extents.empty() ? 0 : 1); k-- > 0;) {
      if (++place[k] < extents[k]) break;
      place[k] = 0;
    }
  }
}

}  // namespace

SweepLayout layout_of(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const auto size_of = [](const SweepPoint& point) {
    return std::accumulate(point.extents.begin(), point.extents.end(), std::size_t{1}, std::multiplies<>());
  };
  const auto largest = std::max_element(
      points.begin(), points.end(), [&](const SweepPoint& a, const SweepPoint& b) { return size_of(a) < size_of(b); });
  Case input = sweep.cases[static_cast<std::size_t>(largest - points.begin())];
  const auto is_list = [](const SweepAxis& axis) { return axis.is_list; };
  // It stands for all points, whatever their speed.
  if (std::any_of(sweep.axes.begin(), sweep.axes.end(), is_list)) input.equilibrium->speeds = {absent};
  SweptResult swept = sweep.experiment->sweeping->not_begun(input).swept(sweep.with_loops);
  for (const SweepPoint& point : points) {
    BUMPFOIL_ASSERT(point.extents.size() == swept.dataset.dims.size());
    BUMPFOIL_ASSERT(point.values.size() == swept.dataset.variables.size());
    for (std::size_t i = 0; i < point.extents.size(); ++i) {
      swept.dataset.dims[i].size = std::max(swept.dataset.dims[i].size, point.extents[i]);
    }
  }
  return {std::move(swept.dataset), std::move(swept.parts)};
}

Dataset sweep_dataset(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const Dataset layout = layout_of(sweep, points).dataset;
  Dataset data{.attributes = {{"swept_command", std::string(sweep.experiment->name)}}};
  std::vector<std::string> keys;
  for (const SweepAxis& axis : sweep.axes) {
    keys.push_back(axis.name);
    data.add_dimension({axis.name, axis.unit, axis.title}, axis.values);
    data.coordinates.back().attributes["case_key"] = axis.swept.key;
  }
  data.dims.insert(data.dims.end(), layout.dims.begin(), layout.dims.end());
  data.coordinates.insert(data.coordinates.end(), layout.coordinates.begin(), layout.coordinates.end());
  for (std::size_t i = 0; i < layout.variables.size(); ++i) {
    const Variable& variable = layout.variables[i];
    std::vector<std::size_t> numbers;  // of the dimensions
    std::vector<std::size_t> extents;
    for (const std::string& name : variable.dims) {
      const auto dim = std::find_if(layout.dims.begin(), layout.dims.end(),
                                    [&name](const DataDimension& one) { return one.name == name; });
      numbers.push_back(static_cast<std::size_t>(dim - layout.dims.begin()));
      extents.push_back(dim->size);
    }
    std::vector<std::string> dims = keys;
    dims.insert(dims.end(), variable.dims.begin(), variable.dims.end());
    const std::size_t size = layout.size_of(variable);
    data.add(variable.meaning, std::move(dims),
             [&points, i, numbers, extents, size] {
               std::vector<double> all(points.size() * size, absent);
               for (std::size_t point = 0; point < points.size(); ++point) {
                 const std::vector<double>& values = points[point].values[i];
                 const std::vector<std::size_t> own =
                     each(numbers, [&](std::size_t number) { return points[point].extents[number]; });
                 copy_block(values, own, extents, all.begin() + static_cast<std::ptrdiff_t>(point * size));
               }
               return all;
             })
        .attributes = variable.attributes;
  }
  return data;
}

}  // namespace bumpfoil
