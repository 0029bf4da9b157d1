#pragma once

#include "ranks.hpp"

namespace bumpfoil {

/// What the program reports to the shell.
enum class ExitCode {
  done = 0,
  wrong_input = 2,
  numerical_failure = 3,  ///< partial results are written and flagged
  file_error = 4,
  interrupted = 130,  ///< partial results are written and flagged
};

/// Reads the command line and runs its command. Prints the help, or what is wrong with the line itself.
/// @param ranks  this is the first one
/// @throws Error and what the command throws
ExitCode run_command_line(int argc, char** argv, const Ranks& ranks);

}  // namespace bumpfoil
