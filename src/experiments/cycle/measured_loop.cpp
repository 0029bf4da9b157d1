#include "bumpfoil/experiments/cycle/measured_loop.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

using Points = std::vector<LoadingCurve::Point>;

constexpr auto by_displacement = [](const LoadingCurve::Point& a, const LoadingCurve::Point& b) {
  return a.displacement < b.displacement;
};

/// A loop that extends to the opposite side by more than this fraction of its range is fully reversed.
constexpr double other_side = 0.5;
/// Reversals below this fraction of the displacement range are ignored: probes and drives are more accurate.
constexpr double least_turn = 0.1;
/// Loop ends closer than this fraction of both ranges meet: the resolution of rigs.
constexpr double least_gap = 0.01;

bool goes_across(double top, double bottom) {
  return bottom < -other_side * top;
}

/// Range (maximum minus minimum) of a member.
double range_of(const Points& points, double LoadingCurve::Point::*member) {
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [member](const auto& a, const auto& b) { return a.*member < b.*member; });
  return *high.*member - *low.*member;
}

/// Turning points of the displacement, lower and upper ones by turns.
struct Turns {
  std::vector<std::size_t> lower;  ///< the first is the start, or precedes all upper ones
  std::vector<std::size_t> upper;
  bool rising{};  ///< whether the displacement increases after the last turn
};

/// @param least  reversal that confirms a turn, m
Turns turns_of(const Points& points, double least) {
  Turns turns;
  std::size_t low = 0;
  std::size_t high = 0;
  bool begun = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].displacement < points[low].displacement) low = i;
    if (points[i].displacement > points[high].displacement) high = i;
    if (!turns.rising && points[i].displacement - points[low].displacement > least) {
      // Data before the first increase are the start, unless the displacement decreases.
      turns.lower.push_back(begun ? low : 0);
      turns.rising = begun = true;
      high = i;
    } else if (turns.rising && points[high].displacement - points[i].displacement > least) {
      turns.upper.push_back(high);
      turns.rising = false;
      low = i;
    } else if (!begun && points[0].displacement - points[low].displacement > least) {
      begun = true;
    }
  }
  // A decreasing end turns at its minimum, though nothing follows.
  if (!turns.rising) turns.lower.push_back(low);
  return turns;
}

}  // namespace

std::optional<LastCycle> last_cycle(const Points& points) {
  if (points.empty()) return std::nullopt;
  const auto displacement = [&points](std::size_t i) { return points[i].displacement; };
  const double least = least_turn * range_of(points, &LoadingCurve::Point::displacement);
  const auto [lower, upper, rising] = turns_of(points, least);
  if (upper.empty()) return std::nullopt;
  LastCycle last{.found = upper.size(), .rest = rising};
  const bool ends_low = !rising;
  // Whether the final decrease belongs to a complete cycle.
  if (ends_low && last.found > 1 && displacement(lower.back()) - displacement(*(lower.end() - 2)) > least) {
    --last.found;
    last.rest = true;
  }
  const std::size_t top = upper[last.found - 1];
  const std::size_t first = lower[last.found - 1];
  std::size_t end = lower[last.found];
  if (!(displacement(top) > 0.0)) return std::nullopt;
  const bool from_middle = last.found == 1 && goes_across(displacement(top), displacement(end)) &&
                           displacement(first) - displacement(end) > least && (rising || upper.size() > 1);
  if (from_middle) last.rest = upper.size() > 1;
  if (!last.rest) {
    end = points.size() - 1;
  } else if (from_middle) {
    end = upper[1];
  }
  last.points.assign(points.begin() + static_cast<std::ptrdiff_t>(first),
                     points.begin() + static_cast<std::ptrdiff_t>(end) + 1);
  if (from_middle) return last;
  const LoadingCurve::Point gap{last.points.back().displacement - last.points.front().displacement,
                                last.points.back().force - last.points.front().force};
  for (const auto member : {&LoadingCurve::Point::displacement, &LoadingCurve::Point::force}) {
    if (std::abs(gap.*member) > least_gap * range_of(last.points, member)) last.gap = gap;
  }
  return last;
}

Cycle measured_cycle(const Points& points, const std::vector<double>& clearance_forces) {
  const auto top = std::max_element(points.begin(), points.end(), by_displacement);
  BUMPFOIL_ASSERT(top != points.begin() && top != points.end() && top + 1 != points.end() && top->displacement > 0.0);
  const auto bottom = std::min_element(top, points.end(), by_displacement);
  const auto end = points.end() - 1;
  Cycle cycle;
  cycle.course = goes_across(top->displacement, bottom->displacement) ? Course::fully_reversed : Course::one_sided;
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
    const bool back = point > top && (cycle.course == Course::one_sided || point <= bottom);
    increment.branch = back ? Branch::unloading : Branch::loading;
    const bool ends_leg = point == top || point == end || (cycle.course == Course::fully_reversed && point == bottom);
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
