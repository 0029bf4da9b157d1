#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bumpfoil/ensemble/ensemble_statistics.hpp"
#include "bumpfoil/ensemble/ensemble_yield.hpp"

namespace bumpfoil {

/// Entries of summary.json for an ensemble: statistics and sensitivities by place and quantity, the yield, and failed
/// samples.
nlohmann::ordered_json ensemble_lists(const Case& input, const EnsembleLayout& layout,
                                      const EnsembleStatistics& statistics, const EnsembleYields& yields);

}  // namespace bumpfoil
