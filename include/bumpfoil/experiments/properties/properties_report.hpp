#pragma once

#include <string>

#include "bumpfoil/experiments/properties/properties.hpp"
#include "bumpfoil/model/bearing_design.hpp"

namespace bumpfoil {

/// Properties of the foils as a text table in the usual units. What is not known is a dash.
std::string properties_table(const PadDesign& pad, const Properties& properties);

/// The same as a JSON object, SI, the unit at the end of each key; what is not known is null.
std::string properties_json(const PadDesign& pad, const Properties& properties);

}  // namespace bumpfoil
