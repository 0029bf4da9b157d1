#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Entries of summary.json for vibrations: `loads`, `vibrations` and `coefficients`.
nlohmann::ordered_json vibration_lists(const Case& input, const VibrationResult& result,
                                       const std::vector<LinearFoils>& all);

}  // namespace bumpfoil
