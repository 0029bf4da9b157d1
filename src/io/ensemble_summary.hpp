#pragma once

#include <string>

#include "bumpfoil/io/ensemble_statistics.hpp"
#include "bumpfoil/io/ensemble_yield.hpp"
#include "bumpfoil/io/summary.hpp"

namespace bumpfoil {

/// Contents of summary.json of an ensemble: statistics and sensitivities by direction and quantity, the yield, and the
/// samples that failed.
std::string ensemble_summary(const Case& input, const EnsembleLayout& layout, const EnsembleStatistics& statistics,
                             const EnsembleYields& yields, RunStatus status, const Manifest& manifest);

}  // namespace bumpfoil
