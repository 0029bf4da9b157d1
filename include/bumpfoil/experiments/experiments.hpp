#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/result_set.hpp"

/// All that can be done to a bearing, each in a folder of its own. A command, its help and its place in the manual, and
/// a function of the Python package follow from what an experiment says of itself here.
namespace bumpfoil {

/// What a run has to show.
struct Outcome {
  RunStatus status{};
  std::string table;                  ///< for the terminal
  std::vector<std::string> warnings;  ///< a line each
  std::vector<std::string> failures;  ///< a line each
  /// Of the result set. netCDF is not thread-safe: to be called by one thread at a time.
  std::function<std::vector<ResultFile>(const Provenance&)> files{};
  std::shared_ptr<const CycleResult> cycles{};  ///< of experiments whose results are cycles
};

/// What is asked of a run beside the keys of its case: --NAME, or --NAME VALUE.
struct Switch {
  std::string_view name;
  std::string_view help;
  std::vector<std::string> values{};  ///< that it takes, the first by default; none: it is on or off
};

/// Switches that were given, and their values.
using Switches = std::map<std::string, std::string>;

/// An experiment, as it says of itself.
struct ExperimentInfo {
  std::string_view name;             ///< of the command, and of the table of the case
  std::string_view summary;          ///< what it does, for --help
  std::string_view examples;         ///< for --help
  std::vector<std::string> files{};  ///< names of all that it writes
  std::vector<Switch> switches{};
  std::optional<EnsembleCommand> sampled{};  ///< it runs samples of an ensemble as well, as this command does there
  /// Runs it. Called with the fraction that is done, `progress` returns false to end the run.
  /// @throws Error (input) if the case cannot be built
  std::function<Outcome(const Case&, const Switches&, const ProgressCallback& progress)> run;
};

/// All experiments, in the order of the manual.
const std::vector<ExperimentInfo>& experiments();

/// The experiment of this name.
const ExperimentInfo& experiment_named(std::string_view name);

}  // namespace bumpfoil
