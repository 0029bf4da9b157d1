#pragma once

#include <string>

#include "bumpfoil/ensemble/ensemble_statistics.hpp"
#include "bumpfoil/ensemble/ensemble_yield.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Contents of summary.json of an ensemble: statistics and sensitivities by direction and quantity, the yield, and the
/// samples that failed.
std::string ensemble_summary(const Case& input, const EnsembleLayout& layout, const EnsembleStatistics& statistics,
                             const EnsembleYields& yields, RunStatus status, const Manifest& manifest);

}  // namespace bumpfoil
