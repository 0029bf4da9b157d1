#pragma once

#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil::test_support {

/// whole_case() read with these overrides.
Case with(const std::vector<std::string>& overrides);

/// The error message for whole_case() with invalid overrides.
std::string refusal(const std::vector<std::string>& overrides);

/// The text with a part removed.
std::string cut(std::string text, const std::string& part);

void expect_in(const std::string& text, const std::string& part);

}  // namespace bumpfoil::test_support
