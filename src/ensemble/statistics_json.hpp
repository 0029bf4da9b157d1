#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bumpfoil/ensemble/statistics.hpp"

namespace bumpfoil {

/// Statistics in the form of summary.json and pages.
nlohmann::ordered_json statistics_json(const Statistics& found);

}  // namespace bumpfoil
