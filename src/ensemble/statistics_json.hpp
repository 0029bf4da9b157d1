#pragma once

#include <nlohmann/json_fwd.hpp>

#include "bumpfoil/ensemble/statistics.hpp"

namespace bumpfoil {

/// Statistics as summary.json and pages have them.
nlohmann::ordered_json statistics_json(const Statistics& found);

}  // namespace bumpfoil
