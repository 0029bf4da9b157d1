#pragma once

#include <cstddef>
#include <vector>

#include "bumpfoil/io/result_quantities.hpp"
#include "bumpfoil/io/sweep.hpp"
#include "io/result_layout.hpp"

namespace bumpfoil {

/// A quantity of a cycle at a point, not a number where it is not known. Of a cycle that was not begun it is known that
/// it did not converge and, of a point that was interrupted, its status.
double value_at(const CycleQuantity& quantity, const Case& input, const SweepPoint& point, std::size_t cycle);

/// The directions of a case in degrees, in its own order, or the numbers of the cycles of its strip.
std::vector<double> places_of(const Case& input, Experiment experiment);

/// Coordinate of the cycles of all points: the directions, or the numbers of the cycles of a strip. Points of a strip
/// may have fewer.
NamedNumbers cycles_of(const Sweep& sweep);

/// Increments of a cycle; points may have fewer.
std::size_t increments_of(const Sweep& sweep);

}  // namespace bumpfoil
