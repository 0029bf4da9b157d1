#pragma once

#include <nlohmann/json.hpp>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// How sleeve and journal of the bearing of a case differ from circles, as report_json describes it; null where they
/// are circles, or where there is no bearing. The case must be valid.
nlohmann::ordered_json shown_deviations(const Case& input);

}  // namespace bumpfoil
