#include "run.hpp"

#include <utility>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/sweep/sweep_files.hpp"
#include "bumpfoil/sweep/sweep_table.hpp"

namespace bumpfoil {
namespace {

/// Does what reads a source; errors of what was given in Python go by their keys alone.
template <typename Reading>
auto with_keys_alone(const Reading& reading) try {
  return reading();
} catch (const Error& error) {
  std::vector<InputError> errors = error.errors();
  for (InputError& one : errors) {
    if (one.file.starts_with("--")) one.file.clear();
    if (one.file.empty()) one.line = 0;
  }
  throw Error(error.kind(), std::move(errors));
}

}  // namespace

Case read_source(const CaseSource& source, const std::vector<std::string>& commands) {
  return with_keys_alone([&] {
    return parse_case(source.text, source.name,
                      {.overrides = source.changes, .commands = commands, .check = errors_of_run});
  });
}

[[noreturn]] void refuse_argument(std::string name, std::string what, std::string advice) {
  throw Error(ErrorKind::input, {{"", 0, std::move(name), "", std::move(what), std::move(advice)}});
}

void check_source(const CaseSource& source) {
  with_keys_alone([&] { return check_case(source.text, source.name, source.changes, errors_of_run); });
}

Sweep read_sweep(const CaseSource& source, const std::string& command, const std::vector<std::string>& over,
                 bool limits) {
  return with_keys_alone([&] {
    return parse_sweep(source.text, source.name,
                       {.command = command, .over = over, .overrides = source.changes, .limits = limits});
  });
}

Provenance provenance_of(const std::string& command, const std::string& case_text) {
  const bool is_verb = command == "fit" || command == "optimise";
  return {.command_line = (is_verb ? "bumpfoil." : "bumpfoil.run_") + command + " (Python)", .case_text = case_text};
}

Run run_command(const std::string& command, const Case& input, const std::string& case_text,
                const ProgressCallback& progress) {
  const ExperimentInfo& experiment = experiment_named(command);
  Outcome outcome = experiment.run(input, progress);
  return {.command = command, .input = input, .outcome = outcome, .files = [=, &experiment] {
            return result_files(experiment, input, outcome, provenance_of(command, case_text));
          }};
}

Run run_sweep(const Sweep& sweep, const std::string& case_text, unsigned threads, const ProgressCallback& progress) {
  std::vector<SweepPoint> points(sweep.cases.size());
  run_in_parallel(
      points.size(), threads,
      [&](std::size_t i, const ProgressCallback& point_progress) { points[i] = run_point(sweep, i, point_progress); },
      progress);
  complete(sweep, points);
  return {.command = "sweep",
          .input = sweep.cases.front(),
          .outcome = {.status = status_of(points),
                      .warnings = warning_lines(sweep, points),
                      .failures = failure_lines(sweep, points)},
          .files = [=, points = std::move(points)] {
            return sweep_files(sweep, points, provenance_of("sweep", case_text));
          }};
}

}  // namespace bumpfoil
