#pragma once

#include <cstddef>

#include "bumpfoil/io/result_quantities.hpp"
#include "bumpfoil/io/sweep.hpp"
#include "io/result_layout.hpp"

namespace bumpfoil {

/// A quantity of a cycle at a point, not a number where it is not known. Of a cycle that was not begun it is known that
/// it did not converge and, of a point that was interrupted, its status.
double value_at(const CycleQuantity& quantity, const Case& input, const SweepPoint& point, std::size_t cycle);

/// The layout of the point with the most cycles, with the increments of the longest: other points may have fewer.
ResultLayout layout_of(const Sweep& sweep);

}  // namespace bumpfoil
