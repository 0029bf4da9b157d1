#pragma once

#include <string>

#include "bumpfoil/experiments/cycle/cycle.hpp"

namespace bumpfoil {

/// Contents of cycle.csv or strip.csv: a header with the units in its names, and one line per cycle and increment.
/// Numbers have 17 significant digits; those that are not finite are left out.
std::string cycle_csv(const CycleResult& result);

}  // namespace bumpfoil
