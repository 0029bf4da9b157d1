#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/ensemble/run_flow.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/results/run_identity.hpp"
#include "bumpfoil/sweep/sweep.hpp"
#include "bumpfoil/sweep/sweep_files.hpp"
#include "bumpfoil/sweep/sweep_table.hpp"
#include "commands.hpp"
#include "experiment.hpp"
#include "interruption.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "shared_runs.hpp"

namespace bumpfoil {
namespace {

struct SweepOptions {
  std::string case_path;
  std::string folder;
  std::string command{"cycle"};
  std::vector<std::string> over;
  std::vector<std::string> overrides;
  std::optional<unsigned> threads;
  bool limits{};
  bool force{};
};

/// Input common to all points of a sweep.
std::string order_of(const Sweep& sweep) {
  return fmt::format("{} {}", sweep.with_loops ? 1 : 0, sweep.experiment->name);
}

ExitCode run_sweep(const SweepOptions& options, const Session& session) {
  // Read once: the case stored with the results is exactly their input.
  const std::string case_text = read_case_text(options.case_path);
  const Sweep sweep = parse_sweep(
      case_text, options.case_path,
      {.command = options.command, .over = options.over, .overrides = options.overrides, .limits = options.limits});
  const InterruptionGuard guard;  // before anything needs cleanup
  ResultFolder folder(options.folder, options.force ? Existing::replace : Existing::refuse, sweep_file_names(sweep));

  std::vector<SweepPoint> points(sweep.cases.size());
  std::string shares;
  {
    ProgressBar bar(!session.quiet, 0.0, session.ranks.size() > 1);
    RunFlow flow(0, points.size(), points.size());
    std::vector<std::atomic<double>> parts(points.size());  // completed fractions
    const auto keep = [&](std::size_t i, SweepPoint point) {
      points[i] = std::move(point);
      parts[i] = 1.0;
      flow.put(i, {});
    };
    RankHelpers helpers(session.ranks, {"sweep", options.threads, order_of(sweep)});
    const auto hand_out = [&](std::size_t count) {
      std::vector<SharedRun> runs = runs_in(flow.take(count));
      for (SharedRun& run : runs) run.bytes = run_identity(sweep.cases[run.number]);
      return runs;
    };
    run_in_parallel(
        flow, std::min(options.threads.value_or(available_threads()), static_cast<unsigned>(points.size())),
        [&](std::size_t i, const ProgressCallback& goes_on) {
          keep(i, run_point(sweep, i, [&](double part) {
                 parts[i] = part;
                 return goes_on(part);
               }));
        },
        [&] {
          helpers.share(hand_out, [&](const SharedRun& run) { keep(run.number, point_of_bytes(run.bytes)); });
          bar.show(std::accumulate(parts.begin(), parts.end(), 0.0) / static_cast<double>(parts.size()));
          return !guard.interrupted();
        });
    shares = helpers.shares_text(points.size(), "points");
  }
  complete(sweep, points);

  const std::string place = printable(options.folder, longest_path);
  const Provenance provenance = provenance_of(session, case_text);
  for (const ResultFile& file : sweep_files(sweep, points, provenance)) folder.stage(file.name, file.contents);
  folder.publish();
  if (!session.quiet) {
    print_output(sweep_table(sweep, points));
    print_output(fmt::format("\n{} points; results in {} ({})\n", points.size(), place,
                             fmt::join(sweep_file_names(sweep), ", ")));
    if (!sweep.with_loops) print_message("warning: sweep.nc does not contain the loops: there are too many");
    print_some("warning: ", warning_lines(sweep, points));
    print_output(shares);
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

RunOfOrder points_of_order(const std::string& order) {
  const ExperimentInfo& experiment = experiment_named(std::string_view(order).substr(2));
  const bool with_loops = order.front() == '1';
  return [&experiment, with_loops](const SharedRun& run, const ProgressCallback& progress) {
    const Sweep sweep{
        .experiment = &experiment, .axes = {}, .cases = {case_of_same_program(run.bytes)}, .with_loops = with_loops};
    const SweepPoint point = run_point(sweep, 0, progress);
    return point.status == RunStatus::interrupted ? std::nullopt : std::optional(bytes_of(point));
  };
}

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
  add_no_times(*command, session);
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
