#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"

namespace bumpfoil {

/// Entries of summary.json for vibrations: `loads`, `vibrations` and `coefficients`.
/// @param data  vibration_dataset() of the result
nlohmann::ordered_json vibration_lists(const Case& input, const VibrationResult& result, const Dataset& data);

}  // namespace bumpfoil
