#include "sweep/sweep_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/results/quantity.hpp"

namespace bumpfoil {
namespace {

/// Copies a block of numbers over some dimensions into a larger one. @param extents  of the block, and of the target
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

/// Adds the additional entries of a dataset, each after its predecessor there.
void merge(const Dataset& more, Dataset& data) {
  for (const DataDimension& dim : more.dims) {
    const auto same = [&dim](const DataDimension& one) { return one.name == dim.name; };
    if (std::none_of(data.dims.begin(), data.dims.end(), same)) data.dims.push_back(dim);
  }
  const auto add = [](const std::vector<Variable>& from, std::vector<Variable>& to) {
    auto place = to.begin();
    for (const Variable& variable : from) {
      const auto same = std::find_if(
          to.begin(), to.end(), [&variable](const Variable& one) { return one.meaning.name == variable.meaning.name; });
      place = std::next(same == to.end() ? to.insert(place, variable) : same);
    }
  };
  add(more.coordinates, data.coordinates);
  add(more.variables, data.variables);
}

/// Size of a dimension of a point; 0 if it has no such dimension.
std::size_t extent_of(const SweepPoint& point, const std::string& name) {
  const auto dim = std::find(point.dims.begin(), point.dims.end(), name);
  return dim == point.dims.end() ? 0 : point.extents[static_cast<std::size_t>(dim - point.dims.begin())];
}

}  // namespace

const std::vector<double>& values_of(const SweepPoint& point, const std::string& name, std::size_t hint) {
  static const std::vector<double> none;
  const std::vector<std::string>& names = point.variables;
  if (hint < names.size() && names[hint] == name) return point.values[hint];
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? none : point.values[static_cast<std::size_t>(found - names.begin())];
}

void merge_names(const std::vector<std::string>& more, std::vector<std::string>& all) {
  auto place = all.begin();
  for (const std::string& name : more) {
    const auto same = std::find(all.begin(), all.end(), name);
    place = std::next(same == all.end() ? all.insert(place, name) : same);
  }
}

SweepLayout layout_of(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const auto size_of = [](const SweepPoint& point) {
    return std::accumulate(point.extents.begin(), point.extents.end(), std::size_t{1}, std::multiplies<>());
  };
  const auto largest = std::max_element(
      points.begin(), points.end(), [&](const SweepPoint& a, const SweepPoint& b) { return size_of(a) < size_of(b); });
  const auto is_list = [](const SweepAxis& axis) { return axis.is_list; };
  const bool lists = std::any_of(sweep.axes.begin(), sweep.axes.end(), is_list);
  const auto not_begun = [&](std::size_t point) {
    Case input = sweep.cases[point];
    if (lists) input.settings.get<EquilibriumSettings>().speeds = {absent};  // represents all points, at any speed
    return sweep.experiment->sweeping->not_begun(input).swept(sweep.with_loops);
  };
  const auto first = static_cast<std::size_t>(largest - points.begin());
  SweptResult swept = not_begun(first);
  std::set<std::vector<std::string>> merged{points[first].variables};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (merged.insert(points[i].variables).second) merge(not_begun(i).dataset, swept.dataset);
  }
  for (DataDimension& dim : swept.dataset.dims) {
    for (const SweepPoint& point : points) dim.size = std::max(dim.size, extent_of(point, dim.name));
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
    const std::vector<std::size_t> extents =
        each(variable.dims, [&layout](const std::string& name) { return layout.dimension(name).size; });
    std::vector<std::string> dims = keys;
    dims.insert(dims.end(), variable.dims.begin(), variable.dims.end());
    const std::size_t size = layout.size_of(variable);
    data.add(variable.meaning, std::move(dims),
             [&points, i, name = variable.meaning.name, over = variable.dims, extents, size] {
               std::vector<double> all(points.size() * size, absent);
               for (std::size_t point = 0; point < points.size(); ++point) {
                 const std::vector<double>& values = values_of(points[point], name, i);
                 const std::vector<std::size_t> own =
                     each(over, [&](const std::string& dim) { return extent_of(points[point], dim); });
                 copy_block(values, own, extents, all.begin() + static_cast<std::ptrdiff_t>(point * size));
               }
               return all;
             })
        .attributes = variable.attributes;
  }
  return data;
}

}  // namespace bumpfoil
