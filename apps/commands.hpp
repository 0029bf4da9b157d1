#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

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

/// What a command is given and gives back.
struct Session {
  const Ranks& ranks;        ///< this is the first one
  std::string command_line;  ///< as a shell would take it again
  bool quiet{};
  ExitCode exit_code{ExitCode::done};
};

/// All that the program takes: commands, options, help. The program parses by it, its manual is made from it.
void describe_program(CLI::App& program, Session& session);

// Each adds its command with options and help to the program; the command runs when it was parsed.
void add_init_command(CLI::App& program, Session& session);
void add_check_command(CLI::App& program, Session& session);
void add_properties_command(CLI::App& program, Session& session);
void add_montecarlo_command(CLI::App& program, Session& session);
void add_sweep_command(CLI::App& program, Session& session);
void add_reproduce_command(CLI::App& program, Session& session);
void add_report_command(CLI::App& program, Session& session);
void add_designer_command(CLI::App& program, Session& session);

/// That a value is one of some words.
CLI::Validator one_of(const std::vector<std::string>& words);

/// Adds the option --set, which changes keys of the case file.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);

/// Adds the option --solver, short for one of them, behind --set.
void add_solver(CLI::App& command, std::vector<std::string>& overrides);

}  // namespace bumpfoil
