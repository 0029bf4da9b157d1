#pragma once

#include <vector>

#include "sweep/swept_result.hpp"

namespace bumpfoil {

/// What the values of points are over: the result of the point with the most of it, of which nothing was begun, with
/// room for the longest of each dimension. Other points may have less.
SweptResult layout_of(const Sweep& sweep, const std::vector<SweepPoint>& points);

}  // namespace bumpfoil
