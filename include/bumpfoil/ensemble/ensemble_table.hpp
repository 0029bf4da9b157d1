#pragma once

#include <string>
#include <vector>

#include "bumpfoil/ensemble/ensemble_statistics.hpp"

namespace bumpfoil {

/// The headline quantities of an ensemble as text, a block for each direction: mean with its standard error, standard
/// deviation and percentiles across; of running bearings and rotors, how many of the samples are stable. What is not
/// known is a dash.
std::string ensemble_table(const EnsembleLayout& layout, const EnsembleStatistics& statistics);

/// A line for each cycle that failed: "sample 17, -X: " and the reason.
std::vector<std::string> failure_lines(const EnsembleLayout& layout, const EnsembleStatistics& statistics);

/// Remarks on the case, and a line for each state of running bearings whose samples lie on several branches: some
/// jumped to another branch on the path and others did not, or the number of detached bumps at the inlet differs by
/// more than one.
std::vector<std::string> warning_lines(const Case& input, const EnsembleLayout& layout,
                                       const EnsembleStatistics& statistics);

}  // namespace bumpfoil
