#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace bumpfoil {

/// Placeholder after an option, or for a positional argument.
struct OptionValue {
  std::string name;                  ///< "DIR"; empty: no value
  std::string rule{};                ///< requirement in the parser's words
  std::vector<std::string> words{};  ///< allowed words, if limited to some
};

OptionValue value_of(CLI::Option& option);

/// "-o" and "--output"; empty for a positional.
std::vector<std::string> spellings_of(const CLI::Option& option);

/// The page for man(1), in roff with the macros of man(7). @param program  set up by describe_program
std::string man_page(CLI::App& program);

/// The script that completes command lines in bash: commands, options, their values, and keys of the case file.
std::string bash_completion(CLI::App& program);

}  // namespace bumpfoil
