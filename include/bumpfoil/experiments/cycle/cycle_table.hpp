#pragma once

#include <string>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// The derived quantities of the cycles as a text table: quantities with their units down, cycles across, six to a
/// block; of many cycles of a strip the first and the last three. What is not known is a dash.
std::string cycle_table(const Case& input, const CycleResult& result);

}  // namespace bumpfoil
