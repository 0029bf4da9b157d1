#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "bumpfoil/analysis/cycle.hpp"
#include "bumpfoil/io/summary.hpp"
#include "commands.hpp"

namespace bumpfoil {

/// A command that runs the cycles of a case and writes them to a folder.
struct ExperimentCommand {
  std::string name;     ///< of the command, and of the table of the case that it needs
  std::string summary;  ///< what it does, for --help
  std::string examples;
  std::function<CycleResult(const Case&, const ProgressCallback&)> run;
};

/// What the shell is told of a run that ended so.
ExitCode exit_code_of(RunStatus status);

/// Adds it to the program.
void add_experiment(CLI::App& program, Session& session, const ExperimentCommand& experiment);

}  // namespace bumpfoil
