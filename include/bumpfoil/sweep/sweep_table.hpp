#pragma once

#include <string>
#include <vector>

#include "bumpfoil/sweep/sweep.hpp"

namespace bumpfoil {

/// Results of a sweep as text, a block for each direction, cycle or vibration: the headline quantities across, the
/// values of a single key down. Of grids, and of more values than fit on a screen, the smallest and the largest of each
/// quantity and where they are. What is not known is a dash.
std::string sweep_table(const Sweep& sweep, const std::vector<SweepPoint>& points);

/// The failure lines of every point behind its name: "friction.coefficient=0.3: -X, increment 37 of 200, ...".
std::vector<std::string> failure_lines(const Sweep& sweep, const std::vector<SweepPoint>& points);

/// Its warnings, the same way.
std::vector<std::string> warning_lines(const Sweep& sweep, const std::vector<SweepPoint>& points);

}  // namespace bumpfoil
