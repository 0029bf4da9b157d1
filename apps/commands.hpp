#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "bumpfoil/results/result_set.hpp"
#include "command_line.hpp"
#include "ranks.hpp"
#include "shared_runs.hpp"

namespace bumpfoil {

/// Input and output of a command.
struct Session {
  const Ranks& ranks;        ///< this process is the first one
  std::string command_line;  ///< quoted for a shell
  bool quiet{};
  bool no_times{};
  ExitCode exit_code{ExitCode::done};
};

/// All commands, options and help texts. Both the parser and the manual are built from it.
void describe_program(CLI::App& program, Session& session);

// Each function adds its command with options and help to the program; the command runs once it is parsed.
void add_init_command(CLI::App& program, Session& session);
void add_check_command(CLI::App& program, Session& session);
void add_properties_command(CLI::App& program, Session& session);
void add_montecarlo_command(CLI::App& program, Session& session);
void add_schema_command(CLI::App& program, Session& session);
void add_export_command(CLI::App& program, Session& session);
void add_sweep_command(CLI::App& program, Session& session);
void add_reproduce_command(CLI::App& program, Session& session);
void add_report_command(CLI::App& program, Session& session);
void add_designer_command(CLI::App& program, Session& session);

// The work of a command on other ranks.
RunOfOrder samples_of_order(const std::string& order);
RunOfOrder points_of_order(const std::string& order);

/// Writes a text to a file and reports it; prints the text if no file is given.
/// @throws Error (file) if the file exists, unless forced, or if writing fails
void write_text(const std::filesystem::path& path, const std::string& text, bool force, const Session& session);

/// Provenance of the results of a session. The recorded command line names the folder, which is not part of a case.
Provenance provenance_of(const Session& session, const std::string& case_text);

/// Adds the option --no-times to a command that writes results.
void add_no_times(CLI::App& command, Session& session);

/// Checks that a value is one of these words.
CLI::Validator one_of(const std::vector<std::string>& words);

/// Adds the option --set, which changes keys of the case file.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);

/// Adds the option --solver, an abbreviation of --set, after the given ones.
void add_solver(CLI::App& command, std::vector<std::string>& overrides);

}  // namespace bumpfoil
