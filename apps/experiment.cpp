#include "experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/ensemble/ensemble_checkpoint.hpp"
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
  bool resume{};
};

/// The case of a sample given as FILE:NUMBER.
Case sampled_case(const std::string& sample, const Case& input, std::string_view command) {
  const std::size_t colon = sample.rfind(':');
  std::size_t number = 0;
  if (colon == std::string::npos || !CLI::detail::lexical_cast(sample.substr(colon + 1), number)) {
    throw Error(ErrorKind::input, {{"", 0, "--sample", sample, "does not end with a sample number",
                                    "write it after the file: results/ensemble.nc:17"}});
  }
  return read_sampled_case(sample.substr(0, colon), number, input, command);
}

/// A fit writes a case.toml: results must not overwrite their own input, under any name.
void require_other_file(const ExperimentOptions& options, const std::vector<std::string>& names) {
  std::error_code code;
  for (const std::string& name : names) {
    const std::filesystem::path path = std::filesystem::path(options.folder) / name;
    if (!std::filesystem::equivalent(path, options.case_path, code)) continue;
    throw Error(ErrorKind::file, {{path.string(), 0, "", "", "is the case of this run, which a result would replace",
                                   "give another folder"}});
  }
}

void remove_all(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) std::filesystem::remove(folder / name);
}

ExitCode run(const ExperimentInfo& experiment, const ExperimentOptions& options, const Session& session) {
  // Read once: the case stored with the results is exactly their input.
  const std::string case_text = read_case_text(options.case_path);
  Case input =
      parse_case(case_text, options.case_path,
                 {.overrides = options.overrides, .commands = {std::string(experiment.name)}, .check = errors_of_run});
  if (!options.sample.empty()) input = sampled_case(options.sample, input, experiment.name);
  require_other_file(options, experiment.files);
  const InterruptionGuard guard;  // before anything needs cleanup
  bool resumes = false;
  for (const std::string& name : experiment.checkpoints) {
    const std::filesystem::path checkpoint = std::filesystem::path(options.folder) / name;
    if (!options.force && !options.resume) require_no_checkpoint(checkpoint, resume_advice);
    resumes |= options.resume && std::filesystem::exists(checkpoint);
  }
  ResultFolder folder(options.folder, options.force || resumes ? Existing::replace : Existing::refuse,
                      experiment.files);

  const Provenance provenance = provenance_of(session, case_text);

  Outcome outcome;
  {
    ProgressBar bar(!session.quiet);
    const auto progress = [&](double fraction) {
      bar.show(fraction);
      return !guard.interrupted();
    };
    outcome = experiment.staged ? experiment.staged(input, {provenance, folder, resumes}, progress)
                                : experiment.run(input, progress);
  }

  const std::string place = printable(options.folder, longest_path);
  std::vector<std::string> written = experiment.files;
  if (outcome.contents) {
    const std::vector<ResultFile> files = result_files(experiment, input, outcome, provenance);
    for (const ResultFile& file : files) folder.stage(file.name, file.contents);
    // Some files are written only with a result: the case of a fit.
    std::erase_if(written, [&files](const std::string& name) {
      return std::none_of(files.begin(), files.end(), [&name](const ResultFile& file) { return file.name == name; });
    });
  }
  folder.publish();
  if (outcome.status != RunStatus::interrupted) remove_all(options.folder, experiment.checkpoints);
  if (!session.quiet) {
    print_output(outcome.table());
    const std::string solvers =
        experiment.solvers ? experiment.solvers(input) : std::string(name_of(input.solver.chosen()));
    print_output(fmt::format("\nsolver {}; results in {} ({})\n", solvers, place, fmt::join(written, ", ")));
    for (const std::string& warning : outcome.warnings) print_message("warning: " + warning);
  }
  const std::string partial = fmt::format("the results in {} are partial and flagged as such", place);
  for (const std::string& failure : outcome.failures) {
    print_message(fmt::format("bumpfoil: {}; {}", failure, partial));
  }
  if (outcome.status == RunStatus::interrupted) {
    print_message("bumpfoil: interrupted: " + partial +
                  (experiment.checkpoints.empty() ? "" : "; to continue, add --resume"));
  }
  return exit_code_of(outcome.status);
}

/// Adds an option that abbreviates a --set.
void add_switch(CLI::App& command, const Switch& one, std::vector<std::string>& overrides) {
  const std::string option = fmt::format("--{}", one.name);
  const std::string help = fmt::format("{}: {}={}", one.help, one.key, one.values.empty() ? one.value : "N");
  const auto set = [&overrides, key = one.key](std::string_view value) {
    overrides.push_back(fmt::format("{}={}", key, value));
  };
  if (one.values.empty()) {
    command.add_flag_callback(
        option, [set, value = one.value] { set(value); }, help);
    return;
  }
  command.add_option_function<std::string>(option, set, help)
      ->check(one_of(one.values))
      ->type_name("N")
      ->default_str(one.values.front());
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

void add_experiment(CLI::App& program, Session& session, const ExperimentInfo& experiment) {
  const auto options = std::make_shared<ExperimentOptions>();
  CLI::App* command = program.add_subcommand(std::string(experiment.name), std::string(experiment.summary));
  command->add_option("CASE", options->case_path, "Case file, or - for the standard input")->required();
  command->add_option("-o,--output", options->folder, fmt::format("Folder for {}", fmt::join(experiment.files, ", ")))
      ->type_name("DIR")
      ->required();
  if (experiment.sampling) {
    command
        ->add_option("--sample", options->sample, "Rerun this sample of an ensemble; CASE is the case of the ensemble")
        ->type_name("ENSEMBLE.NC:NUMBER");
  }
  add_overrides(*command, options->overrides);
  add_solver(*command, options->overrides);
  for (const Switch& one : experiment.switches) add_switch(*command, one, options->overrides);
  CLI::Option* force = command->add_flag("--force", options->force, "Replace existing results in the folder");
  if (!experiment.checkpoints.empty()) {
    command->add_flag("--resume", options->resume, "Continue a run that was killed or interrupted")->excludes(force);
  }
  add_no_times(*command, session);
  command->footer("Examples:\n" + std::string(experiment.examples) +
                  "Ctrl-C, or the time limit of a batch system, ends the run; partial results are written and flagged. "
                  "A second Ctrl-C ends it at once.");
  command->callback([options, &experiment, &session] { session.exit_code = run(experiment, *options, session); });
}

}  // namespace bumpfoil
