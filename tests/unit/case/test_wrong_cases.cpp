#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "support/temporary_folder.hpp"
#include "support/wrong_cases.hpp"

namespace bumpfoil {
namespace {

using test_support::WrongCase;

/// Reads the text from a file, as the program does.
std::vector<InputError> errors_of(const std::string& text) {
  const test_support::TemporaryFolder folder;
  try {
    const std::string file = folder.write("wrong.toml", text);
    static_cast<void>(check_case(read_case_text(file), file));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.errors();
  }
  return {};
}

bool says(const InputError& error, const WrongCase& wrong) {
  const std::string message = format_error(error);
  return (wrong.line == 0 || error.line == wrong.line) &&
         std::all_of(wrong.fragments.begin(), wrong.fragments.end(),
                     [&](const std::string& fragment) { return message.find(fragment) != std::string::npos; });
}

std::string listed(const std::vector<InputError>& errors) {
  std::string out;
  for (const InputError& error : errors) out += format_error(error) + '\n';
  return out;
}

TEST(WholeCase, IsRight) {
  const std::vector<InputError> errors = errors_of(test_support::whole_case());
  EXPECT_TRUE(errors.empty()) << listed(errors);
}

TEST(WrongCases, EveryErrorIsNamedOnceWithPlaceAndAdvice) {
  for (const WrongCase& wrong : test_support::wrong_cases()) {
    SCOPED_TRACE(wrong.name);
    const std::vector<InputError> errors = errors_of(wrong.text);
    EXPECT_EQ(errors.size(), wrong.errors) << listed(errors);
    EXPECT_TRUE(std::any_of(errors.begin(), errors.end(), [&](const InputError& error) { return says(error, wrong); }))
        << "line " << wrong.line << " of:\n"
        << listed(errors);
    for (const InputError& error : errors) {
      EXPECT_NE(error.file.find("wrong.toml"), std::string::npos);
      EXPECT_FALSE(error.what.empty());
      EXPECT_FALSE(error.advice.empty()) << format_error(error);
      for (const char c : format_error(error)) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << "control character";
    }
  }
}

TEST(WrongCases, AreManyAndHaveNoTwins) {
  std::set<std::string> names, texts;
  for (const WrongCase& wrong : test_support::wrong_cases()) {
    names.insert(wrong.name);
    texts.insert(wrong.text);
  }
  EXPECT_GE(names.size(), 80U);
  EXPECT_EQ(texts.size(), names.size());
}

TEST(WrongCase, SaysEverythingAtOnce) {
  std::string text = test_support::whole_case();
  const auto replace = [&text](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  replace("title", "titel");                         // line 1
  replace("\"19.05 mm\"", "\"-19.05 mm\"");          // line 3
  replace("\"38.1 mm\"", "\"38.1 N\"");              // line 4
  replace("bumps = 26", "bumps = \"26\"");           // line 10
  replace("\"3.556 mm\"", "\"5 mm\"");               // line 12
  replace("coefficient = 0.1", "coefficient = -1");  // line 27
  replace("\"37.5 deg\"", "37.5");                   // line 32
  const std::vector<InputError> errors = errors_of(text);
  std::vector<std::size_t> lines;
  for (const InputError& error : errors) lines.push_back(error.line);
  EXPECT_EQ(lines, (std::vector<std::size_t>{1, 3, 4, 11, 13, 28, 33})) << listed(errors);
}

}  // namespace
}  // namespace bumpfoil
