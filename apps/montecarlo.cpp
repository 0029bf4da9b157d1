#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/ensemble/ensemble_checkpoint.hpp"
#include "bumpfoil/ensemble/ensemble_files.hpp"
#include "bumpfoil/ensemble/ensemble_layout.hpp"
#include "bumpfoil/ensemble/ensemble_run.hpp"
#include "bumpfoil/ensemble/ensemble_table.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/results/row_log.hpp"
#include "bumpfoil/results/run_identity.hpp"
#include "commands.hpp"
#include "experiment.hpp"
#include "interruption.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "shared_runs.hpp"

namespace bumpfoil {
namespace {

struct MonteCarloOptions {
  std::string case_path;
  std::string folder;
  std::string samples;
  std::string seed;
  std::optional<unsigned> threads;
  std::optional<double> target_error;
  std::vector<std::string> limits;
  bool film_limits{};
  std::vector<std::string> overrides;
  bool force{};
  bool resume{};
};

/// Rate of completed samples, for the terminal.
class Rate {
 public:
  explicit Rate(std::size_t before) : before_(static_cast<double>(before)) {}

  [[nodiscard]] std::string text(double done) const {
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    return fmt::format("{:.3g} samples/s", (done - before_) / elapsed);
  }

 private:
  using Clock = std::chrono::steady_clock;
  double before_;
  Clock::time_point start_{Clock::now()};
};

CLI::Validator positive_number() {
  return {[](const std::string& text) -> std::string {
            double number = 0.0;
            if (CLI::detail::lexical_cast(text, number) && number > 0.0) return {};
            return fmt::format("must be a positive number, not '{}'", printable(text));
          },
          "positive"};
}

// A row is sent in its memory representation.
std::string bytes_of_row(const std::vector<double>& row) {
  return {reinterpret_cast<const char*>(row.data()), row.size() * sizeof(double)};
}

std::vector<double> row_of(const std::string& bytes) {
  std::vector<double> row(bytes.size() / sizeof(double));
  std::memcpy(row.data(), bytes.data(), row.size() * sizeof(double));
  return row;
}

/// The case with options applied as keys. Errors in them are reported for the option as typed.
Case parse_ensemble_case(const std::string& case_text, const MonteCarloOptions& options) {
  struct Shorthand {
    std::string option, key, value;
  };
  std::vector<Shorthand> given{{"--samples", "montecarlo.samples", options.samples},
                               {"--seed", "montecarlo.seed", options.seed},
                               {"--limits", "montecarlo.limits", options.film_limits ? "true" : ""}};
  std::erase_if(given, [](const Shorthand& one) { return one.value.empty(); });
  CaseRequest request{.overrides = options.overrides, .commands = {"montecarlo"}};
  for (const Shorthand& one : given) request.overrides.push_back(one.key + '=' + one.value);
  try {
    return parse_case(case_text, options.case_path, request);
  } catch (const Error& error) {
    std::vector<InputError> errors = error.errors();
    for (InputError& wrong : errors) {
      const auto blamed =
          std::find_if(given.begin(), given.end(), [&](const Shorthand& one) { return one.key == wrong.key; });
      if (blamed == given.end()) continue;
      wrong.file.clear();
      wrong.key = blamed->option;
    }
    throw Error(error.kind(), std::move(errors));
  }
}

ExitCode run_montecarlo(const MonteCarloOptions& options, const Session& session) {
  const std::string case_text = read_case_text(options.case_path);
  const Case input = parse_ensemble_case(case_text, options);
  const InterruptionGuard guard;  // before anything needs cleanup
  const std::filesystem::path checkpoint = std::filesystem::path(options.folder) / checkpoint_name;
  const bool resumes = options.resume && RowLog::identity_of(checkpoint).has_value();
  const Existing existing = options.force || resumes ? Existing::replace : Existing::refuse;
  ResultFolder folder(options.folder, existing, ensemble_file_names());
  if (!options.force && !options.resume) {
    require_no_checkpoint(checkpoint, resume_advice);
  }

  const EnsembleLayout layout = make_ensemble_layout(input);
  const std::vector<EnsembleLimit> limits = parse_limits(options.limits, layout);
  RowLog log = open_ensemble_log(checkpoint, resumes, input, layout.width());
  bool finished = false;
  const std::size_t before = log.rows();
  std::string shares;
  {
    const bool has_log = session.ranks.size() > 1;
    ProgressBar bar(!session.quiet, static_cast<double>(before) / input.montecarlo->samples, has_log);
    const Rate rate(before);
    const auto enough = [&] {
      return options.target_error && relative_error_of_mean(layout, log) < *options.target_error;
    };
    const auto progress = [&](double done) {
      bar.show(done / input.montecarlo->samples, rate.text(done));
      return !guard.interrupted();
    };
    RankHelpers helpers(session.ranks, {"montecarlo", options.threads, run_identity(input)});
    const auto share = [&](RunFlow& flow) {
      helpers.share([&](std::size_t count) { return runs_in(flow.take(count)); },
                    [&](const SharedRun& run) { flow.put(run.number, row_of(run.bytes)); });
    };
    finished = run_ensemble(input, layout, log,
                            {.threads = options.threads.value_or(available_threads()),
                             .progress = progress,
                             .enough = enough,
                             .share = share});
    shares = helpers.shares_text(log.rows() - before, "samples");
  }
  if (finished && session.no_times) log.rewrite_evenly();

  const EnsembleStatistics statistics = make_ensemble_statistics(input, layout, log);
  const RunStatus status = status_of(statistics, !finished);
  const EnsembleYields yields = make_yields(limits, layout, log);
  stage_ensemble(input, layout, log, statistics, yields, status, provenance_of(session, case_text), folder);
  folder.publish();
  const std::string place = printable(options.folder, longest_path);
  if (!session.quiet) {
    print_output(ensemble_table(layout, statistics));
    print_output(yield_text(yields));
    print_some("warning: ", warning_lines(input, layout, statistics));
    print_output(shares);
    print_output(fmt::format("\n{} samples; results in {} (summary.json, ensemble.nc)\n", statistics.samples, place));
  }
  print_some("bumpfoil: ", failure_lines(layout, statistics));
  if (status == RunStatus::interrupted) {
    print_message(fmt::format("bumpfoil: interrupted: {} of {} samples are missing",
                              static_cast<std::size_t>(input.montecarlo->samples) - statistics.samples,
                              input.montecarlo->samples));
  }
  if (status != RunStatus::complete) {
    print_message(fmt::format("bumpfoil: the results in {} are partial and flagged as such", place));
  }
  return exit_code_of(status);
}

}  // namespace

RunOfOrder samples_of_order(const std::string& order) {
  struct Ensemble {
    explicit Ensemble(Case of_all) : input(std::move(of_all)) {}
    Case input;
    EnsembleLayout layout{make_ensemble_layout(input)};
    EnsembleSampler sampler{input, layout};
  };
  return [ensemble = std::make_shared<Ensemble>(case_of_same_program(order))](
             const SharedRun& run, const ProgressCallback& progress) -> std::optional<std::string> {
    const auto row = ensemble->sampler.run(run.number, progress);
    return row ? std::optional(bytes_of_row(*row)) : std::nullopt;
  };
}

void add_montecarlo_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<MonteCarloOptions>();
  CLI::App* command = program.add_subcommand(
      "montecarlo", "Run the cycles, states or rotors of many random bearings within the tolerances of [montecarlo]");
  command->add_option("CASE", options->case_path, "Case file, or - for the standard input")->required();
  command->add_option("-o,--output", options->folder, "Folder for summary.json and ensemble.nc")
      ->type_name("DIR")
      ->required();
  command->add_option("--samples", options->samples, "Same as --set montecarlo.samples=N")->type_name("N");
  command->add_option("--seed", options->seed, "Same as --set montecarlo.seed=S")->type_name("S");
  command->add_flag(
      "--limits", options->film_limits,
      "Also lift-off speeds and load capacities of running bearings; same as --set montecarlo.limits=true");
  command->add_option("--threads", options->threads, "Number of samples run in parallel; results do not depend on it")
      ->check(CLI::Range(1U, 1024U).description("1 to 1024"))
      ->type_name("N");
  add_overrides(*command, options->overrides);
  add_solver(*command, options->overrides);
  command
      ->add_option("--target-error", options->target_error,
                   "Stop when the standard error of the mean of the maximum force (for running bearings: of the "
                   "minimum film thickness; for rotors: of stable_up_to or largest_amplitude) is below this fraction "
                   "of it everywhere; checked after every 1000 samples")
      ->check(positive_number())
      ->type_name("E");
  command
      ->add_option(
          "--limit", options->limits,
          "Limit that a bearing must meet in every direction or state, \"clearance_5N > 20 um\"; may be repeated")
      ->type_name("LIMIT")
      ->allow_extra_args(false)
      ->take_all();
  CLI::Option* resume = command->add_flag(
      "--resume", options->resume, "Continue a run that was killed or interrupted, or extend it to more samples");
  command->add_flag("--force", options->force, "Replace existing results in the folder")->excludes(resume);
  add_no_times(*command, session);
  command->footer(
      "Examples:\n"
      "  bumpfoil montecarlo examples/tolerances.toml -o tolerances\n"
      "  bumpfoil montecarlo examples/tolerances.toml -o more --samples 10000 --seed 2\n"
      "  bumpfoil cycle examples/tolerances.toml --sample tolerances/ensemble.nc:17 -o seventeen\n"
      "  bumpfoil montecarlo examples/running_tolerances.toml -o running --limit 'h_min > 3 um'\n"
      "  bumpfoil montecarlo examples/rotor_tolerances.toml -o rotors --limit 'stable_up_to > 12000 rpm'\n"
      "A sample depends only on its number and the seed, not on threads or the number of samples. A sample that fails "
      "is kept, with its status. Ctrl-C ends the run; finished samples are written; to continue, add --resume. Samples "
      "are saved in ensemble.checkpoint as they finish, for --resume only.");
  command->callback([options, &session] { session.exit_code = run_montecarlo(*options, session); });
}

}  // namespace bumpfoil
