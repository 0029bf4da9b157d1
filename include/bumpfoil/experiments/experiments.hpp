#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/sampling.hpp"
#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/dataset.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/results/table.hpp"

/// All experiments on a bearing, each in its own folder. The command, its help and its place in the manual, and a
/// function of the Python package follow from the description of an experiment here.
namespace bumpfoil {

/// A part of a result that tables of sweeps show by itself: a direction, a vibration.
struct SweptPart {
  std::string name;
  std::size_t place{};  ///< among the values of its headlines
};

/// A result as sweeps keep it.
struct SweptResult {
  Dataset dataset;
  std::vector<SweptPart> parts;
  Table rows;                 ///< of sweep.csv
  std::vector<Table> more{};  ///< of Sweeping::more_tables
  std::string lists;          ///< of summary.json: a JSON object
};

struct ResultContents;  // private to the library: result_files() takes it

/// What a run has to show.
struct Outcome {
  RunStatus status{};
  std::vector<std::string> warnings;     ///< a line each
  std::vector<std::string> failures;     ///< a line each
  std::function<std::string()> table{};  ///< for the terminal
  std::function<Dataset()> dataset{};    ///< of result.nc; lives as long as this
  /// What its files have beside that; null if they are staged as the run goes.
  std::function<ResultContents(const std::string& run_id)> contents{};
  std::function<SweptResult(bool with_loops)> swept{};  ///< of experiments that can be swept; lives as long as this
  std::shared_ptr<const CycleResult> cycles{};          ///< of experiments whose results are cycles
};

/// Runs an experiment. Called with the fraction that is done, `progress` returns false to end the run.
/// @throws Error (input) if the case cannot be built
using ExperimentRun = std::function<Outcome(const Case&, const ProgressCallback& progress)>;

/// Where a run stages its files as it goes.
struct StagedRun {
  const Provenance& provenance;
  ResultFolder& folder;
  bool resumes{};  ///< it goes on from what it finds there
};

/// A key that an option sets: --NAME, or --NAME VALUE.
struct Switch {
  std::string_view name;
  std::string_view help;
  std::string_view key;               ///< "equilibrium.limits"
  std::string_view value{};           ///< that it sets the key to
  std::vector<std::string> values{};  ///< that it takes instead, the first by default
};

/// How an experiment is run at the points of a sweep.
struct Sweeping {
  ExperimentRun run;
  std::function<Outcome(const Case&)> not_begun;  ///< a run that ended before its first result
  /// Numbers of each of displacement and force in all of its loops; nothing where it has none.
  std::function<std::size_t(const Case&)> loop_values{};
  std::vector<std::string> more_tables{};  ///< names of CSV files beside sweep.csv
};

/// An experiment, as it says of itself.
struct ExperimentInfo {
  std::string_view name;             ///< of the command, and of the table of the case
  std::string_view summary;          ///< what it does, for --help
  std::string_view examples;         ///< for --help
  std::vector<std::string> files{};  ///< names of all that it writes
  std::string_view advice;           ///< how to reduce the memory that its results take
  std::vector<Switch> switches{};
  ExperimentRun run;
  /// Errors of a valid case that only the experiment itself can find; may be left out.
  std::function<std::vector<InputError>(const Case&)> check{};
  std::function<std::string(const Case&)> solvers{};  ///< names of those it takes; null: the solver of the case
  /// Runs it for the command line, and stages its files as it goes: of an experiment whose results the memory may not
  /// hold. Its outcome has the totals, and no files. Others are run, and then written.
  std::function<Outcome(const Case&, const StagedRun& run, const ProgressCallback& progress)> staged{};
  /// Files that a staged run keeps in its folder as long as it takes, with which it can go on after it was stopped.
  std::vector<std::string> checkpoints{};
  std::optional<Sweeping> sweeping{};  ///< of those that can be swept
  std::optional<Sampling> sampling{};  ///< of those that ensembles can run
  /// Quantities of its cycles, vibrations or states, in the order of tables. Long names may leave words open.
  std::vector<VariableMeaning> quantities{};
  /// Quantities of parts with tables of their own: of each speed, revolution, motion or orbit of a rotor.
  std::vector<VariableMeaning> part_quantities{};
  /// Small runs of the reference case, each with keys of its own, whose results together have all variables that there
  /// may be: the first plain, others with what adds some.
  std::vector<std::vector<std::string>> small_runs{};
};

/// All experiments, in the order of the manual.
const std::vector<ExperimentInfo>& experiments();

/// The experiment of this name.
const ExperimentInfo& experiment_named(std::string_view name);

/// The files of a run, with one new run id: its tables as CSV, its texts, its dataset as netCDF-4 with CF conventions,
/// and summary.json with their checksums, so that readers detect a damaged or mixed set. What is not
/// known is the fill value of its variable, and null in summary.json.
/// | netCDF is not thread-safe: call from one thread at a time.
/// @param outcome  with contents
/// @throws Error (file) if memory does not suffice
std::vector<ResultFile> result_files(const ExperimentInfo& experiment, const Case& input, const Outcome& outcome,
                                     const Provenance& provenance);

/// What the check of the experiment of this name finds in a case; nothing where there is no such experiment, or it has
/// no check. A CaseCheck.
std::vector<InputError> errors_of_run(const std::string& command, const Case& input);

}  // namespace bumpfoil
