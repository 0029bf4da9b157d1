#pragma once

#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"

namespace bumpfoil::test_support {

/// whole_case() as it is read with these overrides.
Case with(const std::vector<std::string>& overrides);

/// What is said of whole_case() with overrides that are wrong.
std::string refusal(const std::vector<std::string>& overrides);

/// A text without a part of it.
std::string cut(std::string text, const std::string& part);

void expect_in(const std::string& text, const std::string& part);

}  // namespace bumpfoil::test_support
