#include "io/sweep_values.hpp"

#include <algorithm>
#include <limits>

#include "bumpfoil/io/summary.hpp"

namespace bumpfoil {

double value_at(const CycleQuantity& quantity, const Case& input, const SweepPoint& point, std::size_t cycle) {
  if (cycle < point.result.cycles.size()) return quantity.value(point.result.cycles[cycle], input);
  if (quantity.name == "converged") return 0.0;
  if (quantity.name == "status" && point.status == RunStatus::interrupted) {
    return static_cast<double>(Status::interrupted);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> places_of(const Case& input, Experiment experiment) {
  if (experiment == Experiment::strip) return make_result_layout(input, experiment).cycles.values;
  std::vector<double> places;
  for (const double direction : input.cycle.directions) places.push_back(to_degrees(direction));
  return places;
}

NamedNumbers cycles_of(const Sweep& sweep) {
  NamedNumbers longest;
  for (const Case& input : sweep.cases) {
    NamedNumbers cycles = make_result_layout(input, sweep.experiment).cycles;
    cycles.values = places_of(input, sweep.experiment);
    if (cycles.values.size() > longest.values.size()) longest = std::move(cycles);
  }
  return longest;
}

std::size_t increments_of(const Sweep& sweep) {
  std::size_t increments = 0;
  for (const Case& input : sweep.cases) {
    increments = std::max(increments, make_result_layout(input, sweep.experiment).increments);
  }
  return increments;
}

}  // namespace bumpfoil
