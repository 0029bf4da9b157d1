#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bumpfoil/core/nearest_name.hpp"
#include "bumpfoil/core/printable.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/model/case_names.hpp"
#include "bumpfoil/results/write_file.hpp"
#include "commands.hpp"
#include "experiment.hpp"
#include "output.hpp"

namespace bumpfoil {

std::vector<SharedCommand> shared_commands() {
  return {{"montecarlo", samples_of_order}, {"sweep", points_of_order}};
}

void write_text(const std::filesystem::path& path, const std::string& text, bool force, const Session& session) {
  if (path.empty()) return print_output(text);
  write_file(path, text, force ? Existing::replace : Existing::refuse);
  if (!session.quiet) print_output("wrote " + printable(path.string(), longest_path) + "\n");
}

Provenance provenance_of(const Session& session, const std::string& case_text) {
  return {
      .command_line = session.no_times ? "" : session.command_line, .case_text = case_text, .times = !session.no_times};
}

void add_no_times(CLI::App& command, Session& session) {
  command.add_flag("--no-times", session.no_times,
                   "Leave dates, computing times and the command line out of the results: the same case gives the same "
                   "bytes every time");
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto refuse = [words](const std::string& value) -> std::string {
    if (std::find(words.begin(), words.end(), value) != words.end()) return "";
    const auto longer =
        std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.starts_with(value); });
    const auto nearest = longer != words.end() && !value.empty() ? std::optional(*longer) : nearest_name(value, words);
    return nearest ? fmt::format("unknown value '{}'; did you mean '{}'?", value, *nearest)
                   : fmt::format("'{}' is not one of {}", value, fmt::join(words, ", "));
  };
  return {refuse, fmt::format("{{{}}}", fmt::join(words, ","))};
}

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command
      .add_option("--set", overrides, "Change keys of the case: friction.coefficient=0.2 bump_foil.height=\"0.5 mm\"")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
}

void add_solver(CLI::App& command, std::vector<std::string>& overrides) {
  command
      .add_option_function<std::string>(
          "--solver", [&overrides](const std::string& name) { overrides.push_back("solver.name=" + name); },
          "The same as --set solver.name=...")
      ->check(one_of({enum_names<SolverName>.begin(), enum_names<SolverName>.end()}))
      ->type_name("NAME");
}

namespace {

/// An option with an empty value would count as not given.
void refuse_empty_values(CLI::App& command) {
  const CLI::Validator given([](const std::string& value) { return value.empty() ? "is empty" : ""; }, "");
  for (CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() > 0) option->check(given);
  }
}

}  // namespace

void describe_program(CLI::App& program, Session& session) {
  program.name("bumpfoil");
  program.description("Mechanics of bump-type gas foil bearings: contact, friction, hysteresis and gas film.");
  program.set_version_flag("-V,--version", fmt::format("bumpfoil {} ({})", version(), commit()), "Show the version");
  program.add_flag("--quiet", session.quiet, "Print errors only");
  program.require_subcommand(1);
  program.fallthrough();
  program.footer(
      "Start with:\n"
      "  bumpfoil init -o case.toml\n"
      "  bumpfoil cycle case.toml -o results\n"
      "  bumpfoil report results\n"
      "'bumpfoil help COMMAND' lists the options of a command. A CASE of - is the standard input.\n"
      "Exit codes: 0 done, 2 wrong input, 3 numerical failure, 4 file cannot be read or written, 130 interrupted.");
  add_init_command(program, session);
  add_check_command(program, session);
  add_properties_command(program, session);
  for (const ExperimentInfo& experiment : experiments()) add_experiment(program, session, experiment);
  add_montecarlo_command(program, session);
  add_sweep_command(program, session);
  add_export_command(program, session);
  add_schema_command(program, session);
  add_reproduce_command(program, session);
  add_report_command(program, session);
  add_designer_command(program, session);
  for (CLI::App* command : program.get_subcommands({})) refuse_empty_values(*command);
}

}  // namespace bumpfoil
