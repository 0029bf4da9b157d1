#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/stability/stability.hpp"

namespace bumpfoil {

/// Entries of summary.json: `onsets`, `speeds` with the motions at each, and quantities of the whole run.
nlohmann::ordered_json stability_lists(const StabilityResult& result);

}  // namespace bumpfoil
