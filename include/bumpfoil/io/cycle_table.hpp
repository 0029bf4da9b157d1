#pragma once

#include <string>

#include "bumpfoil/analysis/cycle.hpp"

namespace bumpfoil {

/// The derived quantities of all cycles as a text table: quantities with their units down, directions across, six to a
/// block. What is not known is a dash.
std::string cycle_table(const CycleResult& result);

}  // namespace bumpfoil
