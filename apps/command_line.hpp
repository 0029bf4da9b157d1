#pragma once

#include "ranks.hpp"

namespace bumpfoil {

/// Exit codes of the program.
enum class ExitCode {
  done = 0,
  wrong_input = 2,
  numerical_failure = 3,  ///< partial results are written and flagged
  file_error = 4,
  interrupted = 130,  ///< partial results are written and flagged
};

/// Reads the command line and runs its command. Prints the help, or errors in the command line itself.
/// @param ranks  this is the first one
/// @throws Error and exceptions of the command
ExitCode run_command_line(int argc, char** argv, const Ranks& ranks);

}  // namespace bumpfoil
