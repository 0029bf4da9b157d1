#pragma once

#include <vector>

#include "bumpfoil/analysis/cycle_quantities.hpp"

namespace bumpfoil {

/// Whether points go from a first to a largest displacement and on from there: those of a loop do.
bool turns_round(const std::vector<LoadingCurve::Point>& points);

/// A loop that was measured, as a cycle: increments of displacement and force, one for each point, and the quantities
/// of a cycle that follow from these two, by the same definitions (see Cycle). Its turning point is the point of the
/// largest displacement; it is a swing where it goes to the other side of zero more than half as far, else a push.
/// Where its ends do not meet, a straight line from the last point to the first closes it for its energy; the line is
/// none of the increments.
///
/// @param points            from start to end, displacements from where the body stands before it is pushed
/// @param clearance_forces  thresholds of the clearances, N
/// @pre  turns_round(points)
Cycle measured_cycle(const std::vector<LoadingCurve::Point>& points, const std::vector<double>& clearance_forces);

}  // namespace bumpfoil
