#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/sweep/sweep.hpp"
#include "bumpfoil/sweep/sweep_files.hpp"
#include "bumpfoil/sweep/sweep_table.hpp"
#include "commands.hpp"
#include "experiment.hpp"
#include "interruption.hpp"
#include "output.hpp"
#include "progress_bar.hpp"

namespace bumpfoil {
namespace {

struct SweepOptions {
  std::string case_path;
  std::string folder;
  std::string command{"cycle"};
  std::vector<std::string> over;
  std::vector<std::string> overrides;
  unsigned threads{available_threads()};
  bool limits{};
  bool force{};
};

ExitCode run_sweep(const SweepOptions& options, const Session& session) {
  // Read once: the case written with the results is the one that they came from.
  const std::string case_text = read_case_text(options.case_path);
  const Sweep sweep = parse_sweep(
      case_text, options.case_path,
      {.command = options.command, .over = options.over, .overrides = options.overrides, .limits = options.limits});
  const InterruptionGuard guard;  // before there is anything to clean up
  ResultFolder folder(options.folder, options.force ? Existing::replace : Existing::refuse, sweep_file_names(sweep));

  std::vector<SweepPoint> points(sweep.cases.size());
  {
    ProgressBar bar(!session.quiet);
    run_in_parallel(
        points.size(), options.threads,
        [&](std::size_t i, const ProgressCallback& progress) { points[i] = run_point(sweep, i, progress); },
        [&](double fraction) {
          bar.show(fraction);
          return !guard.interrupted();
        });
  }
  complete(sweep, points);

  const std::string place = printable(options.folder, longest_path);
  const Provenance provenance{.command_line = session.command_line, .case_text = case_text};
  for (const ResultFile& file : sweep_files(sweep, points, provenance)) folder.stage(file.name, file.contents);
  folder.publish();
  if (!session.quiet) {
    print_output(sweep_table(sweep, points));
    print_output(fmt::format("\n{} points; results in {} ({})\n", points.size(), place,
                             fmt::join(sweep_file_names(sweep), ", ")));
    if (!sweep.with_loops) print_message("warning: sweep.nc does not contain the loops: there are too many");
    print_some("warning: ", warning_lines(sweep, points));
  }
  print_some("bumpfoil: ", failure_lines(sweep, points));
  const RunStatus status = status_of(points);
  if (status == RunStatus::interrupted) {
    const auto missing = std::count_if(points.begin(), points.end(),
                                       [](const SweepPoint& point) { return point.status == RunStatus::interrupted; });
    print_message(fmt::format("bumpfoil: interrupted: {} of {} points are missing", missing, points.size()));
  }
  if (status != RunStatus::complete) {
    print_message(fmt::format("bumpfoil: the results in {} are partial and flagged as such", place));
  }
  return exit_code_of(status);
}

}  // namespace

void add_sweep_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App* command =
      program.add_subcommand("sweep", "Run a command for every value of one or several keys, on all cores");
  command->add_option("CASE", options->case_path, "Case file, or - for the standard input")->required();
  command
      ->add_option("--over", options->over,
                   "Key and values: friction.coefficient=0:0.5:0.05 (TO included), or a list, cycle.amplitude=[60 um, "
                   "80 um]; one speed per point for equilibrium.speeds; if repeated, every combination is run")
      ->type_name("KEY=FROM:TO:STEP")
      ->allow_extra_args(false)
      ->take_all()
      ->required();
  command
      ->add_option("-o,--output", options->folder,
                   "Folder for summary.json, sweep.csv and sweep.nc, for equilibrium also coefficients.csv")
      ->type_name("DIR")
      ->required();
  command->add_option("--command", options->command, "Command that is run at every point")
      ->check(one_of(swept_commands()))
      ->capture_default_str();
  command->add_flag(
      "--limits", options->limits,
      "For equilibrium: also lift-off speeds and load capacities, at a film thickness of film.h_lift_off");
  command->add_option("--threads", options->threads, "Number of points run in parallel; results do not depend on it")
      ->check(CLI::Range(1U, 1024U).description("1 to 1024"))
      ->type_name("N");
  add_overrides(*command, options->overrides);
  add_solver(*command, options->overrides);
  command->add_flag("--force", options->force, "Replace existing results in the folder");
  command->footer(fmt::format(
      "Examples:\n"
      "  bumpfoil sweep case.toml --over friction.coefficient=0:0.5:0.05 -o friction\n"
      "  bumpfoil sweep case.toml --over 'cycle.amplitude=60 um:90 um:10 um' --over 'friction.coefficient=[0.05, 0.1]' "
      "-o grid\n"
      "  bumpfoil sweep case.toml --over 'bump_foil.bumps=[20, 26, 32]' --set cycle.steps=50 -o bumps\n"
      "  bumpfoil sweep examples/strip.toml --command strip --over 'strip.displacement=5 um:25 um:5 um' -o strips\n"
      "  bumpfoil sweep examples/vibration.toml --command vibration --over friction.coefficient=0.05:0.2:0.05 -o K\n"
      "  bumpfoil sweep examples/running.toml --command equilibrium --over 'bearing.radial_clearance=[25 um, 30 um]' "
      "-o clearance\n"
      "  bumpfoil sweep examples/running.toml --command equilibrium --over 'equilibrium.speeds=20000 rpm:60000 "
      "rpm:10000 rpm' -o speeds\n"
      "A grid has at most {} points. All cases are checked before the first one runs. A point that fails is kept, with "
      "its status. Ctrl-C ends the run; partial results are written and flagged.",
      most_sweep_points));
  command->callback([options, &session] { session.exit_code = run_sweep(*options, session); });
}

}  // namespace bumpfoil
