#pragma once

#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// What is to be said of a bearing whatever is done to it: the remarks of its reader, and what follows from the forming
/// of its top foils.
std::vector<std::string> case_warnings(const Case& input);

/// The same of all bearings that carry the rotor.
std::vector<std::string> rotor_case_warnings(const Case& input);

}  // namespace bumpfoil
