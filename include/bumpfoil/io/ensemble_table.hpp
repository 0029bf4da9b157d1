#pragma once

#include <string>
#include <vector>

#include "bumpfoil/io/ensemble_statistics.hpp"

namespace bumpfoil {

/// The headline quantities of an ensemble as text, a block for each direction: mean with its standard error, standard
/// deviation and percentiles across. What is not known is a dash.
std::string ensemble_table(const EnsembleLayout& layout, const EnsembleStatistics& statistics);

/// A line for each cycle that failed: "sample 17, -X: " and the reason.
std::vector<std::string> failure_lines(const EnsembleLayout& layout, const EnsembleStatistics& statistics);

}  // namespace bumpfoil
