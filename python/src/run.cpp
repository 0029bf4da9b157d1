#include "run.hpp"

#include <utility>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/experiments/cycle/failures.hpp"
#include "bumpfoil/experiments/cycle/warnings.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_files.hpp"
#include "bumpfoil/experiments/cycle/cycle_summary.hpp"
#include "bumpfoil/experiments/path/path.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/vibration/vibration.hpp"
#include "bumpfoil/experiments/vibration/vibration_files.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/sweep/sweep_files.hpp"
#include "bumpfoil/sweep/sweep_table.hpp"

namespace bumpfoil {
namespace {

/// Does what reads a source; faults of what was given in Python go by their keys alone.
template <typename Reading>
auto told_by_keys(const Reading& reading) try {
  return reading();
} catch (const Error& error) {
  std::vector<Fault> faults = error.faults();
  for (Fault& fault : faults) {
    if (fault.file.starts_with("--")) fault.file.clear();
    if (fault.file.empty()) fault.line = 0;
  }
  throw Error(error.kind(), std::move(faults));
}

Run cycle_run(const std::string& command, const Case& input, const std::string& case_text, CycleResult computed) {
  const auto result = std::make_shared<const CycleResult>(std::move(computed));
  const RunStatus status = status_of(*result);
  return {.command = command,
          .input = input,
          .status = status,
          .warnings = warning_lines(input, *result),
          .failures = failure_lines(input, *result),
          .files = [=] { return cycle_files(input, *result, status, provenance_of(command, case_text)); },
          .cycles = result};
}

Run vibration_run(const Case& input, const std::string& case_text, VibrationResult result) {
  const RunStatus status = status_of(result);
  Run run{.command = "vibration",
          .input = input,
          .status = status,
          .warnings = warning_lines(input, result),
          .failures = failure_lines(input, result),
          .files = {}};
  run.files = [=, result = std::move(result)] {
    return vibration_files(input, result, status, provenance_of("vibration", case_text));
  };
  return run;
}

Run equilibrium_run(const Case& input, const std::string& case_text, EquilibriumResult result) {
  const RunStatus status = status_of(result);
  Run run{.command = "equilibrium",
          .input = input,
          .status = status,
          .warnings = warning_lines(input, result),
          .failures = failure_lines(result),
          .files = {}};
  run.files = [=, result = std::move(result)] {
    return equilibrium_files(input, result, status, provenance_of("equilibrium", case_text));
  };
  return run;
}

}  // namespace

Case read_source(const CaseSource& source, const std::vector<std::string>& commands) {
  return told_by_keys(
      [&] { return parse_case(source.text, source.name, {.overrides = source.changes, .commands = commands}); });
}

void check_source(const CaseSource& source) {
  told_by_keys([&] { return check_case(source.text, source.name, source.changes); });
}

Sweep read_sweep(const CaseSource& source, SweptCommand command, const std::vector<std::string>& over, bool limits) {
  return told_by_keys([&] {
    return parse_sweep(source.text, source.name,
                       {.command = command, .over = over, .overrides = source.changes, .limits = limits});
  });
}

Provenance provenance_of(const std::string& command, const std::string& case_text) {
  return {.command_line = "bumpfoil.run_" + command + " (Python)", .case_text = case_text};
}

Run run_command(const std::string& command, const Case& input, const std::string& case_text,
                const ProgressCallback& progress) {
  if (command == "strip") return cycle_run(command, input, case_text, run_strip(input, progress));
  if (command == "path") return cycle_run(command, input, case_text, run_path(input, progress));
  if (command == "vibration") return vibration_run(input, case_text, run_vibration(input, progress));
  return cycle_run("cycle", input, case_text, run_cycles(input, progress));
}

Run find_running_states(const Case& input, const std::string& case_text, const RunningRequest& request,
                        const ProgressCallback& progress) {
  return equilibrium_run(input, case_text, analyse_running_bearing(input, request, progress));
}

Run run_sweep(const Sweep& sweep, const std::string& case_text, unsigned threads, const ProgressCallback& progress) {
  std::vector<SweepPoint> points(sweep.cases.size());
  run_in_parallel(
      points.size(), threads,
      [&](std::size_t i, const ProgressCallback& point_progress) { points[i] = run_point(sweep, i, point_progress); },
      progress);
  complete(sweep, points);
  Run run{.command = "sweep",
          .input = sweep.cases.front(),
          .status = status_of(points),
          .warnings = warning_lines(sweep, points),
          .failures = failure_lines(sweep, points),
          .files = {}};
  run.files = [=, points = std::move(points)] { return sweep_files(sweep, points, provenance_of("sweep", case_text)); };
  return run;
}

}  // namespace bumpfoil
