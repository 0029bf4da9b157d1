#pragma once

#include <string>
#include <vector>

namespace bumpfoil::test_support {

/// A valid case file in which every optional key stands, too.
std::string whole_case();

/// Line (from 1) in which `fragment` stands; 0 if it does not.
std::size_t line_of(const std::string& text, const std::string& fragment);

/// A case file that is wrong, and what must be said about it.
struct WrongCase {
  std::string name;
  std::string text;
  std::size_t faults{1};
  std::size_t line{};                  ///< that the first expected fault must name; 0 if it has none
  std::vector<std::string> fragments;  ///< of its message, each of which must be there
};

/// The table of wrong case files.
std::vector<WrongCase> wrong_cases();

}  // namespace bumpfoil::test_support
