#include "experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/ensemble/ensemble_files.hpp"
#include "bumpfoil/experiments/cycle/cycle_files.hpp"
#include "bumpfoil/experiments/cycle/cycle_summary.hpp"
#include "bumpfoil/experiments/cycle/cycle_table.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/readers/sampled_case.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "interruption.hpp"
#include "output.hpp"
#include "progress_bar.hpp"

namespace bumpfoil {
namespace {

struct ExperimentOptions {
  std::string case_path;
  std::string folder;
  std::string sample;
  std::vector<std::string> overrides;
  bool force{};
};

/// The case of a sample that is given as FILE:NUMBER.
Case sampled_case(const std::string& sample, const Case& input, EnsembleCommand command) {
  const std::size_t colon = sample.rfind(':');
  std::size_t number = 0;
  if (colon == std::string::npos || !CLI::detail::lexical_cast(sample.substr(colon + 1), number)) {
    throw Error(ErrorKind::input, {{"", 0, "--sample", sample, "does not end with the number of a sample",
                                    "write it behind the file: results/ensemble.nc:17"}});
  }
  return read_sampled_case(sample.substr(0, colon), number, input, command);
}

ExitCode run(const ExperimentCommand& experiment, const ExperimentOptions& options, const Session& session) {
  // Read once: what is written beside the results is what they came from.
  const std::string case_text = read_case_text(options.case_path);
  Case input =
      parse_case(case_text, options.case_path, {.overrides = options.overrides, .commands = {experiment.name}});
  if (!options.sample.empty()) input = sampled_case(options.sample, input, *experiment.sampled);
  const InterruptionGuard guard;  // from before there is anything to clean up
  ResultFolder folder(options.folder, options.force ? Existing::replace : Existing::refuse, experiment.files);

  Outcome outcome;
  {
    ProgressBar bar(!session.quiet);
    outcome = experiment.run(input, [&](double fraction) {
      bar.show(fraction);
      return !guard.interrupted();
    });
  }

  const std::string place = printable(options.folder, longest_path);
  const Provenance provenance{.command_line = session.command_line, .case_text = case_text};
  for (const ResultFile& file : outcome.files(provenance)) folder.stage(file.name, file.contents);
  folder.publish();
  if (!session.quiet) {
    print_output(outcome.table);
    print_output(fmt::format("\nsolver {}; results in {} ({})\n", name_of(input.solver.chosen()), place,
                             fmt::join(experiment.files, ", ")));
    for (const std::string& warning : outcome.warnings) print_message("warning: " + warning);
  }
  const std::string partial = fmt::format("the results in {} are partial, and flagged so", place);
  for (const std::string& failure : outcome.failures) {
    print_message(fmt::format("bumpfoil: {}; {}", failure, partial));
  }
  if (outcome.status == RunStatus::interrupted) print_message("bumpfoil: interrupted: " + partial);
  return exit_code_of(outcome.status);
}

}  // namespace

ExitCode exit_code_of(RunStatus status) {
  switch (status) {
    case RunStatus::complete:
      return ExitCode::done;
    case RunStatus::failed:
      return ExitCode::numerical_failure;
    case RunStatus::interrupted:
      return ExitCode::interrupted;
  }
  return ExitCode::numerical_failure;
}

ExperimentCommand cycle_experiment(std::string name, std::string summary, std::string examples,
                                   CycleResult (*run)(const Case&, const ProgressCallback&)) {
  std::vector<std::string> files = cycle_file_names(name);
  return {.name = std::move(name),
          .summary = std::move(summary),
          .examples = std::move(examples),
          .files = std::move(files),
          .run = [run](const Case& input, const ProgressCallback& progress) {
            CycleResult result = run(input, progress);
            const RunStatus status = status_of(result);
            Outcome outcome{.status = status,
                            .table = cycle_table(input, result),
                            .warnings = warning_lines(input, result),
                            .failures = failure_lines(input, result),
                            .files = {}};
            outcome.files = [input, status, result = std::move(result)](const Provenance& provenance) {
              return cycle_files(input, result, status, provenance);
            };
            return outcome;
          }};
}

CLI::App* add_experiment(CLI::App& program, Session& session, const ExperimentCommand& experiment) {
  const auto options = std::make_shared<ExperimentOptions>();
  CLI::App* command = program.add_subcommand(experiment.name, experiment.summary);
  command->add_option("CASE", options->case_path, "Case file, or - for the standard input")->required();
  command->add_option("-o,--output", options->folder, fmt::format("Folder for {}", fmt::join(experiment.files, ", ")))
      ->type_name("DIR")
      ->required();
  if (experiment.sampled) {
    command->add_option("--sample", options->sample, "Of an ensemble, the bearing of this number; CASE is its case")
        ->type_name("ENSEMBLE.NC:NUMBER");
  }
  add_overrides(*command, options->overrides);
  add_solver(*command, options->overrides);
  command->add_flag("--force", options->force, "Replace results that the folder holds");
  command->footer("Examples:\n" + experiment.examples +
                  "Ctrl-C, or a limit of a batch system, ends the run; what there is by then is written and flagged as "
                  "partial. A second Ctrl-C ends it at once.");
  command->callback([options, experiment, &session] { session.exit_code = run(experiment, *options, session); });
  return command;
}

}  // namespace bumpfoil
