#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle_quantities.hpp"

namespace bumpfoil {

/// Of points that were measured, those of the last whole cycle.
struct LastCycle {
  std::vector<LoadingCurve::Point> points{};  ///< from start to end
  std::size_t found{};                        ///< how many whole cycles there are
  bool rest{};                                ///< whether they go on after it, by a part of a cycle
  /// From the first of `points` to the last; absent where it is less than 1 % of the range of both, and of the first
  /// cycle to both sides, which does not begin where it turns.
  std::optional<LoadingCurve::Point> gap{};
};

/// Finds the last whole cycle by the turning points of the displacement: a turn back by less than a tenth of its range
/// is noise. A cycle goes from a lower turning point up and down to the next one, the first from the start; of a single
/// cycle to both sides of zero the way back belongs to it. The last need not come lower than the one before by more
/// than that tenth to be whole.
/// @return absent where no displacement above zero is reached and left again
std::optional<LastCycle> last_cycle(const std::vector<LoadingCurve::Point>& points);

/// A loop that was measured, as a cycle: increments of displacement and force, one for each point, and the quantities
/// of a cycle that follow from these two, by the same definitions (see Cycle). Its turning point is the point of the
/// largest displacement; it is fully reversed where it goes to the other side of zero more than half as far, else
/// one-sided. Where its ends do not meet, a straight line from the last point to the first closes it for its energy;
/// the line is none of the increments.
///
/// @param points            of one cycle from start to end, see last_cycle(), displacements from where the body stands
/// before it is pushed
/// @param clearance_forces  thresholds of the clearances, N
/// @pre  the largest displacement is above zero, and neither the first point nor the last
Cycle measured_cycle(const std::vector<LoadingCurve::Point>& points, const std::vector<double>& clearance_forces);

}  // namespace bumpfoil
