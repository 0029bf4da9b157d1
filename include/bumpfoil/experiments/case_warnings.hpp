#pragma once

#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil {

/// Warnings about a bearing that apply to every command: the remarks of its reader, and those on the forming of its top
/// foils.
std::vector<std::string> case_warnings(const Case& input);

/// The same for all bearings that carry the rotor.
std::vector<std::string> rotor_case_warnings(const Case& input);

}  // namespace bumpfoil
