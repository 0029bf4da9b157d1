#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/experiments/case_warnings.hpp"
#include "bumpfoil/experiments/experiments.hpp"
#include "commands.hpp"
#include "output.hpp"

namespace bumpfoil {
namespace {

struct CheckOptions {
  std::string case_path;
  std::vector<std::string> overrides;
};

/// The results of all checks as comment lines.
std::string verdicts(const std::vector<CheckedCommand>& commands) {
  std::string out = commands.empty() ? "" : "\n";
  for (const CheckedCommand& command : commands) {
    out += fmt::format("# {}: {}\n", command.name, command.errors.empty() ? "ok" : "not possible");
    for (const InputError& error : command.errors) out += fmt::format("#   {}\n", format_error(error));
  }
  return out;
}

}  // namespace

void add_check_command(CLI::App& program, Session& session) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = program.add_subcommand("check", "Validate a case; print it as interpreted, in SI");
  command->add_option("CASE", options->case_path, "Case file, or - for the standard input")->required();
  add_overrides(*command, options->overrides);
  command->footer(
      "Example:\n"
      "  bumpfoil check case.toml\n"
      "The output is itself a case file. Comments at its end list the commands that it has a table for: which can run "
      "it, and why others cannot. If none can, that is an error.");
  command->callback([options, &session] {
    const CheckedCase checked =
        check_case(read_case_text(options->case_path), options->case_path, options->overrides, errors_of_run);
    if (!session.quiet) print_some("warning: ", case_warnings(checked.input));
    if (!session.quiet) print_output(case_to_toml(checked.input) + verdicts(checked.commands));
  });
}

}  // namespace bumpfoil
