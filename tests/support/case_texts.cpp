#include "support/case_texts.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "support/wrong_cases.hpp"

namespace bumpfoil::test_support {

Case with(const std::vector<std::string>& overrides) {
  return parse_case(whole_case(), "case.toml", {.overrides = overrides, .commands = {}});
}

std::string refusal(const std::vector<std::string>& overrides) {
  try {
    with(overrides);
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

std::string cut(std::string text, const std::string& part) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) ADD_FAILURE() << "no " << part;
  return text.erase(at, part.size());
}

void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

}  // namespace bumpfoil::test_support
