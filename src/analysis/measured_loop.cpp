#include "bumpfoil/analysis/measured_loop.hpp"

#include <algorithm>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

using Points = std::vector<LoadingCurve::Point>;

constexpr auto by_displacement = [](const LoadingCurve::Point& a, const LoadingCurve::Point& b) {
  return a.displacement < b.displacement;
};

/// A loop that goes to the other side by more than this part of its way is a swing.
constexpr double other_side = 0.5;

}  // namespace

bool turns_round(const Points& points) {
  const auto top = std::max_element(points.begin(), points.end(), by_displacement);
  return top != points.begin() && top != points.end() && top + 1 != points.end() && top->displacement > 0.0;
}

Cycle measured_cycle(const Points& points, const std::vector<double>& clearance_forces) {
  BUMPFOIL_ASSERT(turns_round(points));
  const auto top = std::max_element(points.begin(), points.end(), by_displacement);
  const auto bottom = std::min_element(top, points.end(), by_displacement);
  const auto end = points.end() - 1;
  Cycle cycle;
  cycle.course = bottom->displacement < -other_side * top->displacement ? Course::swing : Course::push;
  cycle.amplitude = top->displacement;
  cycle.steps = static_cast<int>(top - points.begin());
  cycle.due = static_cast<int>(points.size()) + 1;
  cycle.clearances.reserve(clearance_forces.size());
  for (const double force : clearance_forces) cycle.clearances.push_back({force, {}});
  cycle.increments.reserve(points.size());

  CycleQuantities quantities(cycle);
  Increment increment;
  for (auto point = points.begin(); point != points.end(); ++point) {
    if (point != points.begin()) {
      ++increment.index;
      increment.work += 0.5 * (point->force + increment.force_direct) * (point->displacement - increment.displacement);
    }
    increment.displacement = point->displacement;
    increment.force_direct = point->force;
    const bool back = point > top && (cycle.course == Course::push || point <= bottom);
    increment.branch = back ? Branch::unloading : Branch::loading;
    const bool ends_leg = point == top || point == end || (cycle.course == Course::swing && point == bottom);
    quantities.add(increment, false, ends_leg);
    cycle.increments.push_back(increment);
  }
  ++increment.index;
  increment.work +=
      0.5 * (points.front().force + increment.force_direct) * (points.front().displacement - increment.displacement);
  quantities.add(increment, false, false);
  quantities.turn({});
  quantities.finish();
  return cycle;
}

}  // namespace bumpfoil
