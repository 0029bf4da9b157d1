#include "sweep/sweep_layout.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {

SweptResult layout_of(const Sweep& sweep, const std::vector<SweepPoint>& points) {
  const auto size_of = [](const SweepPoint& point) {
    return std::accumulate(point.extents.begin(), point.extents.end(), std::size_t{1}, std::multiplies<>());
  };
  const auto largest = std::max_element(
      points.begin(), points.end(), [&](const SweepPoint& a, const SweepPoint& b) { return size_of(a) < size_of(b); });
  SweptResult layout = not_begun(sweep, sweep.cases[static_cast<std::size_t>(largest - points.begin())], true);
  for (const SweepPoint& point : points) {
    BUMPFOIL_ASSERT(point.extents.size() == layout.grid.dims.size());
    BUMPFOIL_ASSERT(point.values.size() == layout.grid.variables.size());
    for (std::size_t i = 0; i < point.extents.size(); ++i) {
      layout.grid.dims[i].size = std::max(layout.grid.dims[i].size, point.extents[i]);
    }
  }
  return layout;
}

}  // namespace bumpfoil
