#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/experiments/cycle/cycle.hpp"
#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "bumpfoil/results/made_folder.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "bumpfoil/studies/gnuplot.hpp"
#include "bumpfoil/studies/study.hpp"
#include "bumpfoil/studies/study_report.hpp"
#include "bumpfoil/studies/study_tables.hpp"
#include "commands.hpp"
#include "interruption.hpp"
#include "output.hpp"
#include "progress_bar.hpp"

namespace bumpfoil {
namespace {

struct ReproduceOptions {
  std::string folder;
  std::vector<int> figures;
  std::vector<std::string> studies;
  bool all{};
  bool force{};
};

/// Figure number of a study, if it is a figure of the paper.
std::optional<int> figure_number(std::string_view study) {
  constexpr std::string_view prefix = "figure";
  if (!study.starts_with(prefix)) return std::nullopt;
  return std::stoi(std::string(study.substr(prefix.size())));
}

/// Requested studies, each once, in the order of study_names(); by default the figures.
std::vector<Study> wanted_studies(const ReproduceOptions& options) {
  const auto among = [](const auto& list, const auto& one) {
    return std::find(list.begin(), list.end(), one) != list.end();
  };
  const bool any_figure = options.figures.empty() && options.studies.empty();
  std::vector<Study> studies;
  for (const std::string& name : study_names()) {
    const std::optional<int> figure = figure_number(name);
    const bool wanted =
        options.all || among(options.studies, name) || (figure && (any_figure || among(options.figures, *figure)));
    if (wanted) studies.push_back(make_study(name));
  }
  return studies;
}

/// A study with its output folders: its own, and one for each run inside it. They are created, or refused, before any
/// computation.
class StudyWriter {
 public:
  StudyWriter(Study study, const std::filesystem::path& path, Existing existing)
      : study_(std::move(study)), folder_(path, existing, file_names(study_)) {
    std::vector<std::string> run_names = cycle_.files;
    run_names.emplace_back("case.toml");
    for (const StudyRun& run : study_.runs) {
      const Case& input = cases_.emplace_back(study_case(run));
      run_folders_.emplace_back(path / run.name, existing, run_names);
      const CycleSettings& cycle = input.settings.get<CycleSettings>();
      increments_ += static_cast<double>(cycle.directions.size()) * (2.0 * cycle.steps + 1.0);
    }
  }

  /// Increments of all runs: the share of this study in the progress.
  [[nodiscard]] double increments() const { return increments_; }

  /// Executes all runs. @return false if interrupted
  bool run(const ProgressCallback& progress) {
    outcomes_.resize(cases_.size());
    return run_in_parallel(
        cases_.size(), available_threads(),
        [this](std::size_t i, const ProgressCallback& progress_of_run) {
          outcomes_[i] = cycle_.run(cases_[i], progress_of_run);
        },
        progress);
  }

  /// Writes the results of all runs, the tables and the picture.
  PlotStatus write(const Session& session) {
    std::vector<StudyRunResult> results;
    for (ResultFolder& folder : run_folders_) {
      const Case& input = cases_[results.size()];
      // One outcome at a time: all results together take hundreds of megabytes.
      const Outcome outcome = std::move(outcomes_[results.size()]);
      const std::string case_text = case_to_toml(input);
      folder.stage("case.toml", case_text);
      for (const ResultFile& file : result_files(cycle_, input, outcome, provenance_of(session, case_text))) {
        folder.stage(file.name, file.contents);
      }
      folder.publish();
      results.push_back({input, *outcome.cycles, outcome.status});
    }
    outcomes_.clear();
    std::vector<StudyTable> tables;
    std::map<std::string, std::string> plot_files;
    for (const StudyTableKind kind : study_.tables) {
      const StudyTable& table = tables.emplace_back(make_study_table(kind, study_, results));
      plot_files[table.name] = folder_.stage(table.name + ".csv", table_csv(table)).string();
    }
    for (const StudyData& data : study_.data) {
      plot_files[std::string(data.name)] = folder_.stage(std::string(data.name) + ".csv", data.csv).string();
    }
    plot_files["picture"] = folder_.stage("picture.svg").string();
    const PlotStatus plotted = run_gnuplot(folder_.stage("picture.gp", study_.plot_script), plot_files);
    if (plotted != PlotStatus::drawn) folder_.discard("picture.svg");
    folder_.stage("study.json", study_json(study_, results, tables));
    folder_.publish();
    outcome_ = outcome_of(study_, results);
    return plotted;
  }

  /// Outcome in terms of the written files.
  [[nodiscard]] const StudyOutcome& outcome() const { return outcome_; }

 private:
  /// All files other than the folders of the runs.
  static std::vector<std::string> file_names(const Study& study) {
    std::vector<std::string> names{"picture.gp", "picture.svg", "study.json"};
    for (const StudyTableKind kind : study.tables) names.push_back(std::string(name_of(kind)) + ".csv");
    for (const StudyData& data : study.data) names.push_back(std::string(data.name) + ".csv");
    return names;
  }

  const ExperimentInfo& cycle_{experiment_named("cycle")};
  Study study_;
  std::vector<Case> cases_;
  ResultFolder folder_;
  std::list<ResultFolder> run_folders_;  ///< inside folder_, so removed before it if they are empty
  std::vector<Outcome> outcomes_;
  StudyOutcome outcome_;
  double increments_{};
};

/// Runs and writes the studies in sequence. @return their outcomes, fewer if it was interrupted
std::vector<StudyOutcome> run_studies(std::list<StudyWriter>& writers, const Session& session,
                                      const InterruptionGuard& guard, PlotStatus& plotted) {
  using std::chrono::steady_clock;
  ProgressBar bar(!session.quiet);
  double all = 0.0;
  for (const StudyWriter& writer : writers) all += writer.increments();
  double done = 0.0;
  std::vector<StudyOutcome> outcomes;
  for (StudyWriter& writer : writers) {
    const steady_clock::time_point start = steady_clock::now();
    const bool finished = writer.run([&](double fraction) {
      bar.show((done + fraction * writer.increments()) / all);
      return !guard.interrupted();
    });
    if (!finished) break;
    plotted = std::max(plotted, writer.write(session));
    done += writer.increments();
    StudyOutcome& outcome = outcomes.emplace_back(writer.outcome());
    outcome.wall_time = std::chrono::duration<double>(steady_clock::now() - start).count();
    if (guard.interrupted()) break;
  }
  return outcomes;
}

ExitCode run_reproduce(const ReproduceOptions& options, const Session& session) {
  const InterruptionGuard guard;            // before anything needs cleanup
  const MadeFolder folder(options.folder);  // before the folders inside it, so removed after them
  std::list<StudyWriter> writers;
  for (Study& study : wanted_studies(options)) {
    const std::filesystem::path path = std::filesystem::path(options.folder) / study.name;
    writers.emplace_back(std::move(study), path, options.force ? Existing::replace : Existing::refuse);
  }
  PlotStatus plotted = PlotStatus::drawn;
  const std::vector<StudyOutcome> outcomes = run_studies(writers, session, guard, plotted);

  const bool interrupted = outcomes.size() < writers.size();
  const bool converged = std::all_of(outcomes.begin(), outcomes.end(), [](const auto& one) { return one.converged; });
  if (!session.quiet) {
    print_output(study_outcomes_table(outcomes));
    print_output(fmt::format(
        "\nresults in {}: for each study picture.svg, study.json, tables (CSV), and a folder for each run\n",
        printable(options.folder, longest_path)));
    if (plotted == PlotStatus::no_gnuplot) {
      print_message(
          "bumpfoil: no plots, because gnuplot is not installed (Debian: gnuplot-nox); once it is, \"gnuplot "
          "picture.gp\" in the folder of a study draws its plot");
    }
  }
  if (plotted == PlotStatus::failed) {
    print_message("bumpfoil: gnuplot failed; run \"gnuplot picture.gp\" in a folder without picture.svg to see why");
  }
  for (const StudyOutcome& outcome : outcomes) {
    for (const std::string& failure : outcome.failures) {
      print_message(fmt::format("bumpfoil: {}; partial results are flagged", failure));
    }
  }
  if (interrupted) {
    print_message(
        fmt::format("bumpfoil: interrupted: {} of {} studies are complete, nothing was written for the others",
                    outcomes.size(), writers.size()));
    return ExitCode::interrupted;
  }
  if (!converged) return ExitCode::numerical_failure;
  return plotted == PlotStatus::failed ? ExitCode::file_error : ExitCode::done;
}

std::vector<std::string> figure_numbers() {
  std::vector<std::string> numbers;
  for (const std::string& name : study_names()) {
    if (const std::optional<int> number = figure_number(name)) numbers.push_back(std::to_string(*number));
  }
  return numbers;
}

}  // namespace

void add_reproduce_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<ReproduceOptions>();
  CLI::App* command =
      program.add_subcommand("reproduce", "Run and plot the studies behind the figures of the 2019 paper, and others");
  command->add_option("-o,--output", options->folder, "Folder for the study folders")->type_name("DIR")->required();
  command->add_option("--figure", options->figures, "Only this figure of the paper; may be repeated")
      ->allow_extra_args(false)
      ->check(one_of(figure_numbers()));
  command->add_option("--study", options->studies, "Only this study; may be repeated")
      ->allow_extra_args(false)
      ->check(one_of(study_names()));
  command->add_flag("--all", options->all, "All figures and all other studies");
  command->add_flag("--force", options->force, "Replace existing results in the folders");
  add_no_times(*command, session);
  std::string footer = "Studies:\n";
  for (const std::string& name : study_names()) footer += fmt::format("  {:<16} {}\n", name, make_study(name).title);
  command->footer(footer +
                  "Examples:\n"
                  "  bumpfoil reproduce -o paper\n"
                  "  bumpfoil reproduce -o paper --figure 10 --figure 11\n"
                  "  bumpfoil reproduce -o paper --study friction\n"
                  "Plots are drawn with gnuplot, if it is installed. Ctrl-C ends the run; finished studies are kept.");
  command->callback([options, &session] { session.exit_code = run_reproduce(*options, session); });
}

}  // namespace bumpfoil
