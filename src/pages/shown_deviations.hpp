#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Deviations of sleeve and journal from circles in a case, as described by report_json; null if there are none, or no
/// bearing. The case must be valid.
nlohmann::ordered_json shown_deviations(const Case& input);

}  // namespace bumpfoil
