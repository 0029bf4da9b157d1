#pragma once

#include <string>
#include <vector>

namespace bumpfoil::test_support {

/// A valid case file that contains every optional key.
std::string whole_case();

/// Line (from 1) that contains `fragment`; 0 if there is none.
std::size_t line_of(const std::string& text, const std::string& fragment);

/// An invalid case file, and its expected message.
struct WrongCase {
  std::string name;
  std::string text;
  std::size_t errors{1};
  std::size_t line{};                  ///< expected in the first error; 0 if it has none
  std::vector<std::string> fragments;  ///< required in its message
};

/// The table of wrong case files.
std::vector<WrongCase> wrong_cases();

}  // namespace bumpfoil::test_support
