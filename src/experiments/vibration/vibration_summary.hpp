#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bumpfoil/experiments/cycle/cycle_summary.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/results/result_set.hpp"

namespace bumpfoil {

/// Contents of summary.json of vibrations: as summary_json(), with `loads`, `vibrations` and `coefficients` in place of
/// cycles.
std::string vibration_summary(const Case& input, const VibrationResult& result, const std::vector<LinearFoils>& all,
                              RunStatus status, const Manifest& manifest);

/// These three lists.
nlohmann::ordered_json vibration_lists(const Case& input, const VibrationResult& result,
                                       const std::vector<LinearFoils>& all);

}  // namespace bumpfoil
