#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/cycle_files.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "commands.hpp"

namespace bumpfoil {

/// What a run has to show.
struct Outcome {
  RunStatus status{};
  std::string table;                  ///< for the terminal
  std::vector<std::string> warnings;  ///< a line each
  std::vector<std::string> failures;
  std::function<std::vector<ResultFile>(const Provenance&)> files;
};

/// A command that does to the foils what its table of the case says, and writes the results to a folder.
struct ExperimentCommand {
  std::string name;
  std::string summary;  ///< what it does, for --help
  std::string examples;
  std::vector<std::string> files;            ///< names of all that it writes
  std::optional<EnsembleCommand> sampled{};  ///< it runs samples of an ensemble as well, as this command does there
  std::function<Outcome(const Case&, const ProgressCallback&)> run;
};

/// One whose result are cycles.
ExperimentCommand cycle_experiment(std::string name, std::string summary, std::string examples,
                                   CycleResult (*run)(const Case&, const ProgressCallback&));

/// What the shell is told of a run that ended so.
ExitCode exit_code_of(RunStatus status);

/// Adds it to the program. @return the command, for options of its own
CLI::App* add_experiment(CLI::App& program, Session& session, const ExperimentCommand& experiment);

}  // namespace bumpfoil
