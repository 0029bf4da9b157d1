#include "io/sweep_values.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace bumpfoil {

double value_at(const CycleQuantity& quantity, const Case& input, const SweepPoint& point, std::size_t cycle) {
  if (cycle < point.result.cycles.size()) return quantity.value(point.result.cycles[cycle], input);
  if (quantity.name == "converged") return 0.0;
  if (quantity.name == "status" && point.status == RunStatus::interrupted) {
    return static_cast<double>(Status::interrupted);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

ResultLayout layout_of(const Sweep& sweep) {
  ResultLayout widest;
  for (const Case& input : sweep.cases) {
    ResultLayout layout = make_result_layout(input, sweep.experiment);
    const std::size_t increments = std::max(widest.increments, layout.increments);
    if (layout.places.size() > widest.places.size()) widest = std::move(layout);
    widest.increments = increments;
  }
  return widest;
}

}  // namespace bumpfoil
